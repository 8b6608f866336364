//! The code of a paper: a few characters that sheet, solutions and scheme of the same paper share.

use super::Key;

/// Letters and digits that are not taken for one another in a hurry.
const ALPHABET: &[u8; 32] = b"23456789ABCDEFGHJKLMNPQRSTUVWXYZ";

/// Six characters from what is asked and with which numbers: `KV7-3QX`. Papers with different questions or numbers
/// have different codes, but for one pair in a thousand million.
pub fn code(key: &Key) -> String {
    // FNV-1a: fixed for ever, and no secret is kept with it.
    let mut digest: u64 = 0xcbf2_9ce4_8422_2325;
    let mut take = |text: &str| {
        for byte in text.bytes().chain([0]) {
            digest = (digest ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for question in &key.questions {
        take(&question.id);
        for (name, value) in &question.parameters {
            take(name);
            take(&value.to_string());
        }
    }
    let folded = digest ^ (digest >> 30);
    let characters = (0..6).map(|place| char::from(ALPHABET[(folded >> (5 * place)) as usize % ALPHABET.len()]));
    let mut code: String = characters.collect();
    code.insert(3, '-');
    code
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::{read_question, shipped};
    use crate::diagnostic::Source;
    use crate::generate::reference;
    use crate::paper::{compose, key_question};

    #[test]
    fn papers_with_other_questions_have_other_codes_and_the_same_paper_the_same() {
        let key = |ids: &[&str]| {
            let questions = ids.iter().map(|id| {
                let (id, text) = shipped().find(|(name, _)| name == id).unwrap();
                let question = read_question(id, &Source::new(id, text)).unwrap();
                let variant = reference(&question).unwrap();
                key_question(&question, &variant, &compose(&question, &variant, 1))
            });
            Key::new("shipped".to_owned(), None, questions.collect())
        };
        let (one, other) = ("rest/speeds-and-directions", "i-j/energy-lost");
        let papers: [&[&str]; 5] = [&[one], &[other], &[one, other], &[other, one], &[one, one]];
        let mut codes: Vec<String> = papers.iter().map(|ids| key(ids).code).collect();
        assert_eq!(codes[0], key(&[one]).code);
        assert!(codes.iter().all(|code| code.len() == 7 && code.as_bytes()[3] == b'-'), "{codes:?}");
        codes.sort();
        codes.dedup();
        assert_eq!(codes.len(), papers.len());
    }
}
