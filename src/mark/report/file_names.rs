//! Names of students as names of files: safe on every machine, each its own, none outside its folder.

use std::collections::HashSet;

/// The longest name, in letters, so that even in four bytes each they leave room for an ending.
const LONGEST: usize = 40;

/// Names that some machines keep for devices.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];

/// A name of a file, without its ending, for each name of a student.
///
/// Letters and digits stay, in lower case; whatever else there is becomes a hyphen. Names that would then be the same,
/// also on a machine that takes capitals for small letters, are numbered.
///
/// ```
/// use carom::mark::report::file_names;
/// let names = file_names(["Ada Lovelace", "ADA/LOVELACE", "../../etc/passwd", "", "Zoë"]);
/// assert_eq!(names, ["ada-lovelace", "ada-lovelace-2", "etc-passwd", "student", "zoë"]);
/// ```
pub fn file_names<'a>(students: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let mut taken = HashSet::new();
    let mut name = |student: &str| {
        let safe = safe(student);
        let numbered = (2..).map(|number| format!("{safe}-{number}"));
        let mut candidates = std::iter::once(safe.clone()).chain(numbered);
        // As machines compare that do not tell capitals from small letters.
        candidates.find(|name| taken.insert(name.to_uppercase().to_lowercase())).unwrap_or(safe)
    };
    students.into_iter().map(&mut name).collect()
}

fn safe(student: &str) -> String {
    let lower = student.chars().take(4 * LONGEST).collect::<String>().to_lowercase();
    let is_kept = |c: char| c.is_alphabetic() || c.is_ascii_digit();
    let words = lower.split(|c| !is_kept(c)).filter(|word| !word.is_empty());
    let name: String = words.collect::<Vec<_>>().join("-").chars().take(LONGEST).collect();
    let name = name.trim_end_matches('-');
    let is_port = |name: &str| {
        name.len() == 4
            && (name.starts_with("com") || name.starts_with("lpt"))
            && name.ends_with(|c: char| c.is_ascii_digit())
    };
    match name {
        "" => "student".to_owned(),
        device if DEVICES.contains(&device) || is_port(device) => format!("{device}-student"),
        name => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_names_that_no_machine_minds() {
        let cases = [
            ("", "student"),
            ("...", "student"),
            ("..", "student"),
            ("CON", "con-student"),
            ("com1", "com1-student"),
            ("com¹", "com"),
            ("a\0b", "a-b"),
            ("C:\\Windows", "c-windows"),
            ("\u{202e}txt.exe", "txt-exe"),
            ("=cmd|'/c calc'!A1", "cmd-c-calc-a1"),
            ("中文", "中文"),
            (".hidden", "hidden"),
        ];
        for (student, expected) in cases {
            assert_eq!(safe(student), expected, "{student:?}");
        }
        assert_eq!(safe(&"Ada ".repeat(10_000)).chars().count(), 39);
        assert!(safe(&"𝒜".repeat(10_000)).len() <= 4 * LONGEST);
    }

    #[test]
    fn carom_knows_each_student_by_a_name_of_its_own() {
        let names = file_names(["Ada", "ada", "ADA", "ada-2", "Ada!", "STRASSE", "straße"]);
        assert_eq!(names, ["ada", "ada-2", "ada-3", "ada-2-2", "ada-4", "strasse", "straße-2"]);
        let many = vec!["-"; 3000];
        let distinct: HashSet<String> = file_names(many).into_iter().collect();
        assert_eq!(distinct.len(), 3000);
    }
}
