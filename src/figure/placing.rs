//! Labels that keep out of each other's way.

use super::drawing::{Drawing, Item, Label, Point};

/// Texts that are placed one after the other, the important ones first.
#[derive(Default)]
pub(super) struct Placing {
    taken: Vec<[Point; 2]>,
}

impl Placing {
    /// Draws a label where it stays inside the drawing and meets no earlier one; says whether it did.
    pub fn try_place(&mut self, drawing: &mut Drawing, label: Label) -> bool {
        self.try_place_apart(drawing, label, 0.0)
    }

    /// Draws a label as [`Self::try_place`] does, with a gap at either side of it.
    pub fn try_place_apart(&mut self, drawing: &mut Drawing, label: Label, gap: f32) -> bool {
        let [min, max] = label.bounds();
        let inside = min[0] >= 0.0
            && min[1] >= 0.0
            && max[0] <= drawing.size[0]
            && max[1] <= drawing.size[1];
        let wide = [[min[0] - gap, min[1]], [max[0] + gap, max[1]]];
        if !inside || self.taken.iter().any(|other| meet(other, &wide)) {
            return false;
        }
        self.place(drawing, label);
        true
    }

    /// Draws a label that has a place of its own.
    pub fn place(&mut self, drawing: &mut Drawing, label: Label) {
        self.taken.push(label.bounds());
        drawing.items.push(Item::Text(label));
    }

    /// Keeps texts out of a rectangle around a point.
    pub fn keep_free(&mut self, center: Point, half: f32) {
        self.taken.push([
            [center[0] - half, center[1] - half],
            [center[0] + half, center[1] + half],
        ]);
    }
}

fn meet(a: &[Point; 2], b: &[Point; 2]) -> bool {
    a[0][0] < b[1][0] && b[0][0] < a[1][0] && a[0][1] < b[1][1] && b[0][1] < a[1][1]
}
