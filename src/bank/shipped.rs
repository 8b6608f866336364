//! The question files inside the binary, by id; a test holds the list to the folder `question_bank`.

/// Id and text of every shipped question, sorted by id.
pub const SHIPPED: &[(&str, &str)] = &[];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::folder::question_files;
    use std::path::Path;

    #[test]
    fn every_file_of_the_bank_is_shipped() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("question_bank");
        let mut ids: Vec<String> = Vec::new();
        if folder.exists() {
            ids = question_files(&folder).unwrap().into_iter().map(|(id, _)| id).collect();
        }
        let shipped: Vec<&str> = SHIPPED.iter().map(|(id, _)| *id).collect();
        assert_eq!(shipped, ids);
        for (id, text) in SHIPPED {
            assert_eq!(*text, std::fs::read_to_string(folder.join(format!("{id}.toml"))).unwrap());
        }
    }
}
