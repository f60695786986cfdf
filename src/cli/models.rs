//! Models on the command line: keys with commas between them.

use crate::brdf::{MODELS, Model, PHONG_FAMILY};
use crate::keys;
use crate::quote::quoted;

/// Models that are chosen.
#[derive(Clone, Debug)]
pub struct Models(pub Vec<&'static Model>);

/// Word for everything that there is to choose.
pub const ALL: &str = "all";
const FAMILY: &str = "phong-family";

/// Help of the option that takes [`parse`].
pub fn help() -> String {
    let keys: Vec<&str> = MODELS.iter().map(|model| model.key).collect();
    format!(
        "Which models, with commas between them: {}; {ALL} is each of them, {FAMILY} the first three",
        keys.join(", ")
    )
}

/// Keys of models with commas between them, each once, in the order of [`MODELS`].
pub fn parse(text: &str) -> Result<Models, String> {
    let mut chosen: Vec<&'static Model> = Vec::new();
    for key in text.split(',').map(str::trim) {
        match (key, Model::by_key(key)) {
            (ALL, _) => chosen.extend(MODELS),
            (FAMILY, _) => chosen.extend(PHONG_FAMILY),
            (_, Some(model)) => chosen.push(model),
            (_, None) => {
                let known = || MODELS.iter().map(|model| model.key).chain([ALL, FAMILY]);
                let all = known().collect::<Vec<_>>().join(", ");
                return Err(format!(
                    "there is no model {}; expected one of {all}{}",
                    quoted(key),
                    keys::did_you_mean(key, known())
                ));
            }
        }
    }
    chosen.sort_by_key(|model| model.index());
    chosen.dedup();
    Ok(Models(chosen))
}
