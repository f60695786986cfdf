//! Names of materials where several have the same one: with the folders in which their files lie.

use std::path::{Path, PathBuf};

/// Names that differ where the files do: a name that several have gets as many of the last folders of its path before it
/// as tell it from the others, or the whole file name where the folders are the same. What has no path keeps its name.
pub fn told_apart(all: &[(String, Option<PathBuf>)]) -> Vec<String> {
    let name = |(name, path): &(String, Option<PathBuf>)| {
        let Some(path) = path else {
            return name.clone();
        };
        let others: Vec<Vec<String>> = all
            .iter()
            .filter(|(other, place)| other == name && place.as_ref() != Some(path))
            .map(|(_, place)| place.as_deref().map(folders).unwrap_or_default())
            .collect();
        if others.is_empty() {
            return name.clone();
        }
        let own = folders(path);
        let last = |folders: &[String], count: usize| {
            folders[folders.len().saturating_sub(count)..].to_vec()
        };
        let shortest = (1..=own.len()).find(|count| {
            let own = last(&own, *count);
            others.iter().all(|other| last(other, *count) != own)
        });
        match shortest {
            Some(count) => format!("{}/{name}", last(&own, count).join("/")),
            // The same folder, or the only one above all.
            None => crate::files::folder::shown_name(path),
        }
    };
    all.iter().map(name).collect()
}

/// Folders of a path, which may be one of another system, from the root on and in one line.
fn folders(path: &Path) -> Vec<String> {
    let text = path.to_string_lossy().replace(char::is_control, " ");
    let mut parts: Vec<String> = text
        .split(['/', '\\'])
        .filter(|part| !part.is_empty())
        .map(str::to_owned)
        .collect();
    parts.pop();
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(all: &[(&str, &str)], wanted: &[&str]) {
        let all: Vec<_> = all
            .iter()
            .map(|(name, path)| ((*name).to_owned(), (!path.is_empty()).then(|| path.into())))
            .collect();
        assert_eq!(told_apart(&all), wanted);
    }

    #[test]
    fn names_get_folders_only_where_they_clash() {
        check(
            &[
                ("steel", "/data/old/steel.binary"),
                ("gold", "/data/old/gold.binary"),
                ("steel", "/data/new/steel.binary"),
            ],
            &["old/steel", "gold", "new/steel"],
        );
        // One folder is enough for the first of them.
        check(
            &[
                ("steel", "/p/a/steel.binary"),
                ("steel", "/p/b/steel.binary"),
                ("steel", "/q/b/steel.binary"),
            ],
            &["a/steel", "p/b/steel", "q/b/steel"],
        );
        check(
            &[
                ("steel", "/run/steel.binary"),
                ("steel", "/p/run/steel.binary"),
                ("steel", "C:\\far\\steel.binary"),
            ],
            &["steel.binary", "p/run/steel", "far/steel"],
        );
    }

    #[test]
    fn the_same_file_has_one_name_and_what_has_none_keeps_its_own() {
        check(
            &[("steel", "/a/steel.binary"), ("steel", "/a/steel.binary")],
            &["steel", "steel"],
        );
        check(&[("steel", ""), ("steel", "")], &["steel", "steel"]);
        check(
            &[("steel", ""), ("steel", "/a/steel.binary")],
            &["steel", "a/steel"],
        );
        check(
            &[("steel", "/a/steel.binary"), ("steel", "/a/steel.merl")],
            &["steel.binary", "steel.merl"],
        );
    }
}
