//! Names of materials where several have the same one, with the folders in which their files lie; and as parts of the names
//! of files.

use super::folder::shown_name;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::{Path, PathBuf};

/// Bytes of a name in the name of a file: a file system takes 255, and there are other words.
const MOST_BYTES: usize = 120;

/// The beginning of a name, as long as the name of a file has room for.
pub fn short(name: &str) -> &str {
    &name[..name.floor_char_boundary(MOST_BYTES)]
}

/// Names that differ where the files do: a name that several have gets as many of the last folders of its path before it
/// as tell it from the others, or the whole file name where the folders are the same. What has no path keeps its name.
pub fn told_apart(all: &[(String, Option<PathBuf>)]) -> Vec<String> {
    let mut by_name: HashMap<&str, Vec<usize>> = HashMap::new();
    for (index, (name, _)) in all.iter().enumerate() {
        by_name.entry(name).or_default().push(index);
    }
    let mut names: Vec<String> = all.iter().map(|(name, _)| name.clone()).collect();
    for (name, indices) in by_name {
        let mut by_path: BTreeMap<&Path, Vec<usize>> = BTreeMap::new();
        let mut without = false;
        for index in indices {
            match &all[index].1 {
                Some(path) => by_path.entry(path).or_default().push(index),
                None => without = true,
            }
        }
        if by_path.len() + usize::from(without) < 2 {
            continue;
        }
        let paths: Vec<&Path> = by_path.keys().copied().collect();
        for (indices, shown) in by_path.values().zip(with_folders(name, &paths)) {
            for index in indices {
                names[*index].clone_from(&shown);
            }
        }
    }
    names
}

/// Names of different files of one name, each with as many of its last folders as tell it from the others.
fn with_folders(name: &str, paths: &[&Path]) -> Vec<String> {
    let all: Vec<Vec<String>> = paths.iter().map(|path| folders(path)).collect();
    // Those whose last folders are the same so far have the same class.
    let mut classes: Vec<Option<usize>> = vec![Some(0); all.len()];
    let mut counts: Vec<Option<usize>> = vec![None; all.len()];
    for count in 1.. {
        let mut next: HashMap<(usize, &str), (usize, usize)> = HashMap::new();
        for (folders, class) in all.iter().zip(&mut classes) {
            let folder = folders.len().checked_sub(count).map(|at| &*folders[at]);
            *class = class.zip(folder).map(|key| {
                let number = next.len();
                let (class, members) = next.entry(key).or_insert((number, 0));
                *members += 1;
                *class
            });
        }
        let single: HashSet<usize> = next
            .into_values()
            .filter(|(_, members)| *members == 1)
            .map(|(class, _)| class)
            .collect();
        for (class, found) in classes.iter_mut().zip(&mut counts) {
            if class.is_some_and(|class| single.contains(&class)) {
                (*class, *found) = (None, Some(count));
            }
        }
        if classes.iter().all(Option::is_none) {
            break;
        }
    }
    let shown = |((path, folders), count): ((&&Path, &Vec<String>), Option<usize>)| match count {
        Some(count) => format!("{}/{name}", folders[folders.len() - count..].join("/")),
        // The same folder, or the only one above all.
        None => shown_name(path),
    };
    paths.iter().zip(&all).zip(counts).map(shown).collect()
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

    /// The definition, one pair at a time.
    fn plain(all: &[(String, Option<PathBuf>)]) -> Vec<String> {
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
                None => shown_name(path),
            }
        };
        all.iter().map(name).collect()
    }

    #[test]
    fn names_are_as_the_definition_has_them() {
        let mut seed = 7u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) % below
        };
        let mut with_folders = 0;
        for _ in 0..2000 {
            let count = 1 + draw(8);
            let mut one = || {
                let name = ["a", "b"][draw(2) as usize].to_owned();
                let folders: String = (0..draw(4))
                    .map(|_| ["/x", "/y"][draw(2) as usize])
                    .collect();
                let path = (draw(6) > 0).then(|| format!("{folders}/{name}.binary").into());
                (name, path)
            };
            let all: Vec<_> = (0..count).map(|_| one()).collect();
            let found = told_apart(&all);
            assert_eq!(found, plain(&all), "{all:?}");
            with_folders += found.iter().filter(|name| name.contains('/')).count();
        }
        assert!(with_folders > 1000, "{with_folders}");
    }

    #[test]
    fn as_many_files_of_one_name_as_a_fit_file_holds_are_told_apart() {
        // Comparing each with each would take an hour.
        let all: Vec<_> = (0..100_000)
            .map(|k| {
                let path = format!("/data/{}/{k}/steel.binary", k % 100);
                ("steel".to_owned(), Some(path.into()))
            })
            .collect();
        let found = told_apart(&all);
        assert_eq!(found[0], "0/steel");
        assert_eq!(found[99_999], "99999/steel");
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
