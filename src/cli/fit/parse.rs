//! The values of the options of `grazing fit`: each function says in one line what is wrong and what was expected.

use crate::brdf::{Param, ParamId, all_params};
use crate::fit::{Partial, Stage, StageSet};
use crate::keys;
use crate::quote::{quoted, shown};

/// A grazing limit in degrees.
pub fn limit(text: &str) -> Result<f64, String> {
    let degrees: Option<f64> = text.trim().parse().ok();
    match degrees {
        Some(degrees) if degrees > 0.0 && degrees <= 90.0 => Ok(degrees),
        Some(degrees) if !degrees.is_nan() => {
            Err("out of range; expected more than 0 and at most 90 degrees".into())
        }
        _ => Err("not a number; expected degrees, more than 0 and at most 90".into()),
    }
}

/// Numbers of stages with commas between them.
pub fn stages(text: &str) -> Result<StageSet, String> {
    let mut stages = StageSet::NONE;
    if text.trim().is_empty() {
        return Err("no stage is given; expected some of 1,2,3,4".into());
    }
    for part in text.split(',') {
        let stage = part.trim().parse().ok().and_then(Stage::by_number);
        let Some(stage) = stage else {
            return Err(format!(
                "{} is no stage; expected some of 1,2,3,4",
                quoted(part)
            ));
        };
        if stages[stage] {
            return Err(format!(
                "stage {} is given twice; expected each at most once",
                stage.number()
            ));
        }
        stages[stage] = true;
    }
    Ok(stages)
}

/// Parameters with values: `s=30,k_s=1:2:3`.
pub fn values(text: &str) -> Result<Partial, String> {
    let mut found = Partial::default();
    let keys = || all_params().map(Param::key);
    let all = || keys().collect::<Vec<_>>().join(", ");
    for part in text.split(',') {
        let Some((key, value)) = part.split_once('=') else {
            return Err(format!(
                "{} has no value; expected KEY=VALUE with a key of {}",
                quoted(part),
                all()
            ));
        };
        let key = key.trim();
        let Some(row) = all_params().find(|row| row.key() == key) else {
            let proposal = keys::did_you_mean(key, keys());
            return Err(format!(
                "there is no parameter {}; expected one of {}{proposal}",
                quoted(key),
                all()
            ));
        };
        if found.has(row.id) {
            return Err(format!("{key} is given twice; give it once"));
        }
        let numbers = numbers(row, value)?;
        let (first, rgb) = match numbers[..] {
            [r, g, b] => (r, [r, g, b]),
            _ => (numbers[0], [numbers[0]; 3]),
        };
        match row.id {
            ParamId::RHO_D => found.rho_d = Some(rgb),
            ParamId::K_S => found.k_s = Some(rgb),
            id => _ = found.shared.insert(id, first),
        }
    }
    Ok(found)
}

/// One number, or three with colons between them for a colour.
fn numbers(row: &Param, text: &str) -> Result<Vec<f64>, String> {
    let key = row.key();
    let (low, high) = row.domain;
    let parts: Vec<&str> = text.split(':').collect();
    if parts.len() != 1 && !(row.id.is_color() && parts.len() == 3) {
        let expected = if row.id.is_color() {
            "one number or three: R:G:B"
        } else {
            "one number"
        };
        return Err(format!(
            "{key} has {} values; expected {expected}",
            parts.len()
        ));
    }
    let number = |part: &str| match part.trim().parse::<f64>() {
        Ok(number) if row.accepts(number) => Ok(number),
        Ok(number) if !number.is_nan() => Err(format!(
            "{key} = {} is out of range; expected {low} to {high}",
            shown(&number.to_string())
        )),
        _ => Err(format!(
            "{key}: {} is no number; expected {low} to {high}",
            quoted(part)
        )),
    };
    parts.into_iter().map(number).collect()
}
