//! The formula of a BRDF in the markup of [`crate::figure::text`]: with symbols, and with its numbers.

use crate::brdf::{Brdf, Fresnel};

/// `f_r = …` with symbols.
pub fn symbolic(brdf: &Brdf) -> String {
    let factor = match brdf.fresnel {
        Fresnel::None => "",
        Fresnel::Exact | Fresnel::Schlick => " R_{F}(ω_{i}·ω_{h}, η)",
    };
    format!(
        "f_{{r}} = ρ_{{d}}/π + k_{{s}}{factor} {}",
        brdf.model.formula
    )
}

/// `f_r = …` with the numbers in; colours as (R, G, B), or one number where they are grey.
pub fn numeric(brdf: &Brdf) -> String {
    let mut lobe = brdf.model.formula.to_string();
    for (row, value) in brdf.model.params.iter().zip(brdf.params.lobe) {
        lobe = substituted(&lobe, row.symbol, &number(value));
    }
    let factor = match brdf.fresnel {
        Fresnel::None => String::new(),
        Fresnel::Exact | Fresnel::Schlick => {
            format!(" R_{{F}}(ω_{{i}}·ω_{{h}}, {})", number(brdf.params.eta))
        }
    };
    format!(
        "f_{{r}} = {}/π + {}{factor} {lobe}",
        color(&brdf.params.rho_d),
        color(&brdf.params.k_s),
    )
}

/// A formula with a number in place of a symbol. The symbol stands alone: the s of "cos" and of an index is not it.
fn substituted(formula: &str, symbol: &str, number: &str) -> String {
    let mut text = String::new();
    let mut rest = formula;
    while let Some(at) = rest.find(symbol) {
        let (before, after) = (&rest[..at], &rest[at + symbol.len()..]);
        text += before;
        let in_word = |c: Option<char>| c.is_some_and(char::is_alphabetic);
        let alone = !in_word(text.chars().next_back())
            && !in_word(after.chars().next())
            && !text.ends_with("_{");
        text += &if alone {
            placed(number, &text, after)
        } else {
            symbol.to_owned()
        };
        rest = after;
    }
    text + rest
}

/// A number as it stands between two pieces of a formula: a power of ten is no part of another power.
fn placed(number: &str, before: &str, after: &str) -> String {
    if before.ends_with("^{") {
        // Levels of scripts do not nest.
        number.replace("·10^{", "e").replace('}', "")
    } else if number.contains('^') && after.starts_with(['²', '^']) {
        format!("({number})")
    } else {
        number.to_owned()
    }
}

fn color(values: &[f64]) -> String {
    if values.iter().all(|value| *value == values[0]) {
        return number(values[0]);
    }
    let parts: Vec<String> = values.iter().map(|value| number(*value)).collect();
    format!("({})", parts.join(", "))
}

/// Three significant digits, without an exponent where it reads well.
pub fn number(value: f64) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e6).contains(&magnitude) {
        let text = format!("{value:.2e}");
        return text.replace('e', "·10^{") + "}";
    }
    let digits_before = magnitude.log10().floor() as i32 + 1;
    let decimals = (3 - digits_before).clamp(0, 5) as usize;
    format!("{value:.decimals$}")
}

/// E in percent with two decimals, as markup.
pub fn hundredths(error: f64) -> String {
    if error.is_nan() {
        "–".into()
    } else if error < 100.0 {
        format!("{:.2}", 100.0 * error)
    } else {
        number(100.0 * error)
    }
}

/// E with its unit, as markup.
pub fn percent(error: f64) -> String {
    format!("{} %", hundredths(error))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::params::lobe_values;

    #[test]
    fn a_symbol_is_replaced_where_it_stands_alone() {
        for (formula, expected) in [("cos^{s}", "cos^{12}"), ("s cos s_{s}", "12 cos 12_{s}")] {
            assert_eq!(substituted(formula, "s", "12"), expected);
        }
        assert_eq!(
            substituted("(1 − α)(ω_{r}·ω_{o})", "α", "0.5"),
            "(1 − 0.5)(ω_{r}·ω_{o})"
        );
    }
    use crate::brdf::{MODELS, Model, Params};
    use crate::figure::RichText;

    #[test]
    fn every_parameter_is_in_the_formula_of_its_model() {
        let live = |model: &Model, symbol: &str| substituted(model.formula, symbol, "?");
        for model in MODELS {
            for row in model.params {
                let text = live(model, row.symbol);
                assert!(text.contains('?'), "{} lacks {}", model.key, row.symbol);
            }
            // Two lines of the panel, of 285 points each, at 15 points.
            let whole = symbolic(&Brdf::new(model, Fresnel::Exact));
            let width = RichText::parse(&whole).width_em();
            println!("{} {width}", model.key);
            assert!(width <= 38.0, "{}: {width}", model.key);
        }
        // Planted: a symbol that stands in no formula, and one that is only a letter of a word.
        assert!(!live(MODELS[0], "α").contains('?'));
        assert!(!substituted("tan²θ_{a} exp", "a", "?").contains('?'));
    }

    #[test]
    fn a_power_of_ten_is_no_part_of_a_power() {
        for (formula, number, expected) in [
            ("x^{s}", "2.00·10^{6}", "x^{2.00e6}"),
            ("s² s", "2.00·10^{−4}", "(2.00·10^{−4})² 2.00·10^{−4}"),
            ("s²", "12", "12²"),
        ] {
            assert_eq!(substituted(formula, "s", number), expected);
        }
    }

    #[test]
    fn formulas_show_the_live_numbers() {
        let params = Params {
            rho_d: [0.25; 3],
            k_s: [1.0, 2.0, 30.0],
            lobe: lobe_values([1234.0, 0.3]),
            eta: 1.5,
        };
        let model = Model::by_key("combined").expect("a model");
        let brdf = Brdf {
            model,
            fresnel: Fresnel::Exact,
            params,
        };
        assert_eq!(
            numeric(&brdf),
            "f_{r} = 0.250/π + (1.00, 2.00, 30.0) R_{F}(ω_{i}·ω_{h}, 1.50) \
             ((1 − 0.300)(ω_{r}·ω_{o}) + 0.300(ω_{h}·n)^{4})^{1234}"
        );
        let plain = Brdf {
            fresnel: Fresnel::None,
            model: Model::by_key("phong").expect("a model"),
            ..brdf
        };
        assert_eq!(
            symbolic(&plain),
            "f_{r} = ρ_{d}/π + k_{s} (ω_{r}·ω_{o})^{s}"
        );
    }

    #[test]
    fn numbers_have_three_digits() {
        for (value, text) in [
            (0.0, "0"),
            (0.01234, "0.0123"),
            (9.876, "9.88"),
            (54321.0, "54321"),
            (2.5e7, "2.50·10^{7}"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
