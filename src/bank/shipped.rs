//! The question files inside the binary: every file of `question_bank/`, listed when carom is built.

/// Path from `question_bank/` and text of every shipped question, sorted by path.
const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/questions.rs"));

/// Id and text of every shipped question, sorted by id.
pub fn shipped() -> impl Iterator<Item = (&'static str, &'static str)> {
    FILES.iter().filter_map(|(path, text)| Some((path.strip_suffix(".toml")?, *text)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::folder::question_files;
    use std::path::Path;

    #[test]
    fn every_file_of_the_bank_is_shipped() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("question_bank");
        let ids: Vec<String> = question_files(&folder).unwrap().into_iter().map(|(id, _)| id).collect();
        assert!(ids.len() >= 17, "{ids:?}");
        assert_eq!(shipped().map(|(id, _)| id).collect::<Vec<_>>(), ids);
    }
}
