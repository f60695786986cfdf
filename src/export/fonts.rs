//! Fonts of the system for letters that the font of figures lacks, found by the letters that they have.
//!
//! They are looked through when a letter is lacking for the first time, and never before.

use crate::figure::write::font::{self, FallbackFont, glyph};
use resvg::usvg::fontdb::{Database, FaceInfo, ID, Style, Weight};
use skrifa::{FontRef, MetadataProvider as _, Tag};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::path::PathBuf;
use std::sync::{Arc, LazyLock, Mutex, OnceLock, PoisonError};

/// Variable of the environment that names a folder of fonts to take instead of those of the system.
pub const VARIABLE: &str = "GRAZING_FONTS";

/// Number of letters that are named in one line.
const NAMED: usize = 6;

static FOLDER: OnceLock<PathBuf> = OnceLock::new();

/// Takes the fonts of a folder instead of those of the system, for the rest of the run. Without effect once a letter was
/// lacking, or a second time.
pub fn look_in(folder: PathBuf) {
    let _ = FOLDER.set(folder);
}

/// Fonts that have the letters, as few as can be; none has those that remain. The same letters give the same fonts.
pub fn for_letters(letters: &BTreeSet<char>) -> Vec<FallbackFont> {
    static FOUND: Mutex<BTreeMap<BTreeSet<char>, Vec<FallbackFont>>> = Mutex::new(BTreeMap::new());
    static DATABASE: LazyLock<Database> = LazyLock::new(database);
    if letters.is_empty() {
        return Vec::new();
    }
    let mut found = FOUND.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(fonts) = found.get(letters) {
        return fonts.clone();
    }
    let fonts = covering(&DATABASE, letters);
    found.insert(letters.clone(), fonts.clone());
    fonts
}

/// Fonts for letters on the screen, where the font of figures stands in too, and the letters that none has.
pub fn for_screen(letters: &BTreeSet<char>) -> (Vec<FallbackFont>, BTreeSet<char>) {
    static OWN: LazyLock<Arc<Vec<u8>>> = LazyLock::new(|| Arc::new(font::BYTES.to_vec()));
    let lacks = |letter: &char, fonts: &[FallbackFont]| glyph(*letter, fonts).id == 0;
    let rest = letters
        .iter()
        .copied()
        .filter(|letter| lacks(letter, &[]))
        .collect();
    let mut fonts = for_letters(&rest);
    let lacking = rest
        .iter()
        .copied()
        .filter(|letter| lacks(letter, &fonts))
        .collect();
    if rest.len() < letters.len() {
        fonts.push(FallbackFont {
            family: font::FAMILY.into(),
            data: Arc::clone(&OWN),
            index: 0,
        });
    }
    (fonts, lacking)
}

/// One line on letters that no font has; `None` without any.
pub fn lacking_text(letters: &BTreeSet<char>) -> Option<String> {
    let named = letters.iter().take(NAMED);
    let named: Vec<String> = named
        .map(|letter| format!("{letter} (U+{:04X})", u32::from(*letter)))
        .collect();
    let more = match letters.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    (!letters.is_empty()).then(|| {
        format!(
            "no font of this system has {}{more}: boxes stand there; install a font that has the script",
            named.join(", ")
        )
    })
}

fn database() -> Database {
    let mut database = Database::new();
    match FOLDER
        .get()
        .cloned()
        .or_else(|| env::var_os(VARIABLE).map(PathBuf::from))
    {
        Some(folder) => database.load_fonts_dir(folder),
        None => database.load_system_fonts(),
    }
    database
}

/// The fonts that have most of what is lacking, one after the other. Of fonts that have as many letters, upright ones of
/// usual weight go first, then those of the first name, so that the order of the files does not matter.
fn covering(database: &Database, letters: &BTreeSet<char>) -> Vec<FallbackFont> {
    let mut faces: Vec<(ID, BTreeSet<char>)> = database
        .faces()
        .map(|face| (face.id, letters_of(database, face.id, letters)))
        .filter(|(_, has)| !has.is_empty())
        .collect();
    let rank = |id: ID| database.face(id).map(rank);
    faces.sort_by_cached_key(|(id, _)| rank(*id));
    let (mut fonts, mut rest) = (Vec::new(), letters.clone());
    while let Some((id, has)) = faces
        .iter()
        // The last of equals is taken.
        .rev()
        .max_by_key(|(_, has)| has.intersection(&rest).count())
        && !has.is_disjoint(&rest)
    {
        rest.retain(|letter| !has.contains(letter));
        fonts.extend(font_of(database, *id));
    }
    fonts
}

fn rank(face: &FaceInfo) -> (bool, Reverse<bool>, u16, String, u32) {
    let name = face.families.first().map_or("", |(name, _)| name.as_str());
    (
        face.style != Style::Normal,
        Reverse(!face.monospaced),
        face.weight.0.abs_diff(Weight::NORMAL.0),
        format!("{name} {}", face.post_script_name),
        face.index,
    )
}

/// Those of the letters that a font has as outlines: pictures of letters are no use in print.
fn letters_of(database: &Database, id: ID, letters: &BTreeSet<char>) -> BTreeSet<char> {
    let found = database.with_face_data(id, |data, index| {
        let font = FontRef::from_index(data, index).ok()?;
        let outlines = [b"glyf", b"CFF ", b"CFF2"];
        let drawn = outlines
            .iter()
            .any(|tag| font.table_data(Tag::new(tag)).is_some());
        let has = |letter: &char| {
            font.charmap()
                .map(*letter)
                .is_some_and(|id| id.to_u32() > 0)
        };
        drawn.then(|| letters.iter().copied().filter(has).collect())
    });
    found.flatten().unwrap_or_default()
}

fn font_of(database: &Database, id: ID) -> Option<FallbackFont> {
    let family = database.face(id)?.families.first()?.0.clone();
    database.with_face_data(id, |data, index| FallbackFont {
        family,
        data: Arc::new(data.to_vec()),
        index,
    })
}
