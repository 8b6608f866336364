//! The question files inside the binary, by id; a test holds the list to the folder `question_bank`.

macro_rules! shipped {
    ($($id:literal,)*) => {
        /// Id and text of every shipped question, sorted by id.
        pub const SHIPPED: &[(&str, &str)] = &[
            $(($id, include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/question_bank/", $id, ".toml"))),)*
        ];
    };
}

// One line for each file of the folder, sorted.
shipped! {
    "backwards/speed-of-b-and-energy-lost",
    "backwards/velocity-of-b-and-line-of-centres",
    "backwards/velocity-of-b-and-restitution",
    "both-moving/components-given",
    "both-moving/energy-lost-and-impulse",
    "both-moving/paths-at-right-angles",
    "both-moving/speeds-and-fraction-of-energy-lost",
    "i-j/energy-lost",
    "i-j/speeds-after-impact",
    "i-j/velocities-after-impact",
    "rest-letters/deflection-from-a-given-angle",
    "rest-letters/direction-and-deflection",
    "rest-letters/distance-from-the-centre-of-b",
    "rest-letters/turned-through-a-right-angle",
    "rest/components-of-each-velocity",
    "rest/heavier-sphere-struck",
    "rest/speeds-and-directions",
}

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
