//! The question files inside the binary, by id; a test holds the list to the folder `question_bank`.

/// Id and text of every shipped question, sorted by id.
#[rustfmt::skip]
pub const SHIPPED: &[(&str, &str)] = &[
    ("backwards/speed-of-b-and-energy-lost", include_str!("../../question_bank/backwards/speed-of-b-and-energy-lost.toml")),
    ("backwards/velocity-of-b-and-line-of-centres", include_str!("../../question_bank/backwards/velocity-of-b-and-line-of-centres.toml")),
    ("backwards/velocity-of-b-and-restitution", include_str!("../../question_bank/backwards/velocity-of-b-and-restitution.toml")),
    ("both-moving/components-given", include_str!("../../question_bank/both-moving/components-given.toml")),
    ("both-moving/energy-lost-and-impulse", include_str!("../../question_bank/both-moving/energy-lost-and-impulse.toml")),
    ("both-moving/paths-at-right-angles", include_str!("../../question_bank/both-moving/paths-at-right-angles.toml")),
    ("both-moving/speeds-and-fraction-of-energy-lost", include_str!("../../question_bank/both-moving/speeds-and-fraction-of-energy-lost.toml")),
    ("i-j/energy-lost", include_str!("../../question_bank/i-j/energy-lost.toml")),
    ("i-j/speeds-after-impact", include_str!("../../question_bank/i-j/speeds-after-impact.toml")),
    ("i-j/velocities-after-impact", include_str!("../../question_bank/i-j/velocities-after-impact.toml")),
    ("rest-letters/deflection-from-a-given-angle", include_str!("../../question_bank/rest-letters/deflection-from-a-given-angle.toml")),
    ("rest-letters/direction-and-deflection", include_str!("../../question_bank/rest-letters/direction-and-deflection.toml")),
    ("rest-letters/distance-from-the-centre-of-b", include_str!("../../question_bank/rest-letters/distance-from-the-centre-of-b.toml")),
    ("rest-letters/turned-through-a-right-angle", include_str!("../../question_bank/rest-letters/turned-through-a-right-angle.toml")),
    ("rest/heavier-sphere-struck", include_str!("../../question_bank/rest/heavier-sphere-struck.toml")),
    ("rest/speeds-and-directions", include_str!("../../question_bank/rest/speeds-and-directions.toml")),
    ("rest/velocity-of-each-sphere", include_str!("../../question_bank/rest/velocity-of-each-sphere.toml")),
];

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
