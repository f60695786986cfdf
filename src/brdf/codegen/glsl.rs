//! Translation of WGSL to GLSL, for the subset of WGSL in which the twins of the models are written: functions,
//! structs, `if` and arithmetic, with the type of every `let` and `var` written out and no types but f32, u32 and
//! vectors.

use super::items::{WgslItems, is_word, tokens};
use super::parts::{USE, ascii, entry, head, library};
use crate::brdf::Brdf;

/// GLSL text that defines `vec3 brdf(vec3 wi, vec3 wo)`, the twin of [`Brdf::f_r`] with 0 below the horizon, for GLSL
/// 1.30 and GLSL ES 3.00 and later.
pub fn glsl(brdf: &Brdf, material: Option<&str>) -> String {
    let items = WgslItems::new(&[&library(brdf), &entry(brdf)]);
    let text = from_wgsl(&items.needed_by("brdf"));
    ascii(&(head(brdf, material, "//") + USE + &text))
}

/// GLSL translation of a WGSL text; tokens that are not known are left as they are.
pub fn from_wgsl(text: &str) -> String {
    let tokens: Vec<&str> = tokens(text).collect();
    let mut writer = Writer {
        tokens: &tokens,
        at: 0,
        out: String::with_capacity(text.len()),
    };
    while let Some(token) = writer.next() {
        writer.translate(token);
    }
    writer.out
}

struct Writer<'a> {
    tokens: &'a [&'a str],
    at: usize,
    out: String,
}

impl<'a> Writer<'a> {
    fn next(&mut self) -> Option<&'a str> {
        let token = self.tokens.get(self.at).copied();
        self.at += 1;
        token
    }

    /// Next token that is not white space; empty at the end.
    fn next_solid(&mut self) -> &'a str {
        loop {
            match self.next() {
                Some(token) if token.starts_with(char::is_whitespace) => {}
                Some(token) => return token,
                None => return "",
            }
        }
    }

    fn peek_solid(&mut self) -> &'a str {
        let at = self.at;
        let token = self.next_solid();
        self.at = at;
        token
    }

    fn translate(&mut self, token: &'a str) {
        match token {
            "struct" => self.structure(),
            "fn" => self.function(),
            "let" | "var" => {
                let declaration = self.declaration();
                self.out.push_str(&declaration);
            }
            "if" => self.condition(),
            // No comma after the last argument.
            "," if self.peek_solid() == ")" => {}
            word => self.out.push_str(renamed(word)),
        }
    }

    /// `type name` in GLSL from the tokens `name: type` that follow.
    fn declaration(&mut self) -> String {
        let name = self.next_solid();
        // The colon.
        self.next_solid();
        let ty = renamed(self.next_solid());
        format!("{ty} {name}")
    }

    fn structure(&mut self) {
        let name = self.next_solid();
        self.out.push_str(&format!("struct {name} {{\n"));
        // The brace.
        self.next_solid();
        while is_name(self.peek_solid()) {
            let field = self.declaration();
            self.out.push_str(&format!("    {field};\n"));
            if self.peek_solid() == "," {
                self.next_solid();
            }
        }
        self.next_solid();
        self.out.push_str("};");
    }

    fn function(&mut self) {
        let name = self.next_solid();
        // The parenthesis.
        self.next_solid();
        let mut parameters = Vec::new();
        while is_name(self.peek_solid()) {
            parameters.push(self.declaration());
            if self.peek_solid() == "," {
                self.next_solid();
            }
        }
        // The parenthesis and both signs of the arrow.
        for _ in 0..3 {
            self.next_solid();
        }
        let result = renamed(self.next_solid());
        let parameters = parameters.join(", ");
        self.out.push_str(&format!("{result} {name}({parameters})"));
    }

    fn condition(&mut self) {
        self.out.push_str("if (");
        while matches!(self.tokens.get(self.at), Some(token) if token.trim().is_empty()) {
            self.at += 1;
        }
        while let Some(token) = self.next() {
            if token == "{" {
                break;
            }
            self.translate(token);
        }
        let end = self.out.trim_end().len();
        self.out.truncate(end);
        self.out.push_str(") {");
    }
}

fn is_name(token: &str) -> bool {
    token.starts_with(is_word)
}

/// GLSL name of a WGSL type or built-in function.
fn renamed(word: &str) -> &str {
    match word {
        "f32" => "float",
        "u32" => "uint",
        "vec2f" => "vec2",
        "vec3f" => "vec3",
        "vec4f" => "vec4",
        "inverseSqrt" => "inversesqrt",
        word => word,
    }
}
