//! The law that words are about: for `NEL`, restitution.

use crate::mechanics::Law;

/// What teachers call laws by their first letters.
const LETTERS: [(&str, &str); 8] = [
    ("nel", "restitution"),
    ("nlr", "restitution"),
    ("nlor", "restitution"),
    ("clm", "momentum"),
    ("colm", "momentum"),
    ("pcm", "momentum"),
    ("pclm", "momentum"),
    ("ke", "energy"),
];

/// Words that begin otherwise than those of the laws, and mean the same.
const ALSO: [(&str, &str); 2] = [("solving", "solve"), ("angle", "direction")];

impl Law {
    /// The law that words are most probably about: by its first letters, or by the words of its mark.
    ///
    /// ```
    /// use carom::mechanics::Law;
    /// assert_eq!(Law::meant("NEL").map(Law::name), Some("restitution"));
    /// assert_eq!(Law::meant("Newton's law").map(Law::name), Some("restitution"));
    /// assert_eq!(Law::meant("colours"), None);
    /// ```
    pub fn meant(words: &str) -> Option<Law> {
        let said = words.to_lowercase();
        if let Some((_, name)) = LETTERS.iter().find(|(letters, _)| *letters == said.replace('.', "").trim()) {
            return Law::ALL.iter().copied().find(|law| law.name() == *name);
        }
        let said = stems(&said);
        let weigh = |law: &Law| {
            let (name, method) = (stems(law.name()), stems(&law.method().0.to_lowercase()));
            let hits = said.iter().filter(|word| name.contains(word) || method.contains(word)).count();
            let missing = name.iter().filter(|word| !said.contains(word)).count();
            2 * hits as i64 - missing as i64
        };
        let weights = Law::ALL.iter().map(|law| (weigh(law), *law)).filter(|(weight, _)| *weight > 0);
        weights.rev().max_by_key(|(weight, _)| *weight).map(|(_, law)| law)
    }

    /// Do words have one of those by which the law is called, or of the words of its mark?
    pub fn is_named_in(self, words: &str) -> bool {
        let said = stems(&words.to_lowercase());
        [self.name(), self.method().0].iter().flat_map(|own| stems(&own.to_lowercase())).any(|own| said.contains(&own))
    }
}

/// How words of some length begin: `Newtons` and `conserved` as `Newton's` and `conservation` do.
fn stems(words: &str) -> Vec<String> {
    let words = words.split(|sign: char| !sign.is_alphabetic()).filter(|word| word.chars().count() > 3);
    let same = |word: &'_ str| ALSO.iter().find(|(also, _)| *also == word).map(|(_, same)| *same);
    words.map(|word| same(word).unwrap_or(word).chars().take(6).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_is_known_by_the_words_of_teachers() {
        let table = [
            ("NEL", "restitution"),
            ("CLM", "momentum"),
            ("conservation of momentum", "momentum"),
            ("Newtons law", "restitution"),
            ("Pythagoras", "speed"),
            ("loss of kinetic energy", "energy"),
            ("resolving", "resolve"),
            ("solving the equations", "solve"),
            ("solving", "solve"),
            ("angle of A", "direction"),
            ("angle of deflection", "deflection"),
        ];
        for (words, law) in table {
            assert_eq!(Law::meant(words).map(Law::name), Some(law), "{words}");
        }
    }
}
