//! Values of data and model at the probe.

use crate::app::state::State;
use crate::app::state::probe::{Probe, ratio};
use crate::geom::{Rgb, directions};

impl State {
    /// The pinned probe, or else what is under the pointer.
    pub fn probe(&self) -> Option<Probe> {
        self.pinned.or(self.hovered)
    }

    /// f_r of the shown material and of its model at a pair of directions.
    pub fn values_at(&self, probe: Probe) -> (Option<Rgb>, Option<Rgb>) {
        let Some((material, opened)) = self.current() else {
            return (None, None);
        };
        let measured = material.table.lookup(probe.wi, probe.wo, self.scene.lookup);
        (measured, opened.brdf.f_r(probe.wi, probe.wo))
    }

    /// The probe's angles in degrees and the values there, tab-separated, under a line that names them.
    pub fn probe_row(&self) -> Option<String> {
        let probe = self.probe()?;
        let (material, opened) = self.current()?;
        let (measured, model) = self.values_at(probe);
        let angles = probe.angles();
        let mut names = vec!["material".to_string(), "model".to_string()];
        let mut values = vec![material.name.clone(), opened.brdf.model.key.to_string()];
        let mut degrees = |name: &str, angle: Option<f64>| {
            names.push(format!("{name}_deg"));
            values.push(angle.map_or(String::new(), |x| format!("{:.6}", x.to_degrees())));
        };
        degrees("theta_i", Some(directions::theta(probe.wi)));
        degrees("phi_i", Some(directions::phi(probe.wi)));
        degrees("theta_o", Some(directions::theta(probe.wo)));
        degrees("phi_o", Some(directions::phi(probe.wo)));
        degrees("theta_h", angles.map(|angles| angles.theta_h));
        degrees("theta_d", angles.map(|angles| angles.theta_d));
        degrees("phi_d", angles.map(|angles| angles.phi_d));
        let ratio = measured
            .zip(model)
            .map(|(measured, model)| ratio(measured, model));
        for (name, rgb) in [("measured", measured), ("model", model), ("ratio", ratio)] {
            for (channel, letter) in ["r", "g", "b"].into_iter().enumerate() {
                names.push(format!("{name}_{letter}"));
                let value = rgb
                    .map(|rgb| rgb[channel])
                    .filter(|value| value.is_finite());
                values.push(value.map_or(String::new(), |value| format!("{value:e}")));
            }
        }
        Some(format!("{}\n{}\n", names.join("\t"), values.join("\t")))
    }
}
