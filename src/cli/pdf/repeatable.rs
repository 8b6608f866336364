//! What a browser writes differently each time that it prints the same page, made the same.
//!
//! All is overwritten in its place by as many bytes: a PDF tells of each object at which byte it begins. Within a string
//! of a PDF a bracket would have a backslash before it, so what is found here is the entry and nothing else.

use std::collections::HashMap;
use std::ops::Range;

/// Makes the same page the same file.
pub fn make_repeatable(pdf: &mut Vec<u8>) {
    leave_out_the_time(pdf);
    if let Some(numbered) = with_headings_in_order(pdf) {
        *pdf = numbered;
    }
}

/// Overwrites the time of printing with blanks.
fn leave_out_the_time(pdf: &mut [u8]) {
    for key in [b"/CreationDate (D:".as_slice(), b"/ModDate (D:"] {
        while let Some(start) = find(pdf, key) {
            let length = find(&pdf[start..], b")").map_or(key.len(), |end| end + 1);
            pdf[start..start + length].fill(b' ');
        }
    }
}

/// How a browser names the headings of a table, so that a cell can say below and beside which it stands: `(node00000023)`.
const NAME: &[u8] = b"(node";
const DIGITS: usize = 8;
const WHOLE_NAME: usize = NAME.len() + DIGITS + 1;

/// The names come in the order of an index, `/Limits [first last] /Names [first 30 0 R … last 203 0 R]`.
const LIMITS: &[u8] = b"/Limits [";
const ENTRIES: &[u8] = b"/Names [";

/// Names the headings 1, 2, 3, … as they stand in the file. A browser numbers them as it first comes to draw them, which
/// depends on what else the machine has to do. None where the index is not one list of such names and nothing else.
fn with_headings_in_order(pdf: &[u8]) -> Option<Vec<u8>> {
    let limits = only(pdf, LIMITS)?;
    let entries = only(pdf, ENTRIES)?;
    let mut pdf = pdf.to_vec();
    let mut numbers: HashMap<Vec<u8>, usize> = HashMap::new();
    for start in places(&pdf, NAME) {
        let digits = start + NAME.len()..start + WHOLE_NAME - 1;
        let name = pdf.get(digits.clone()).filter(|name| name.iter().all(u8::is_ascii_digit))?;
        if pdf.get(digits.end) != Some(&b')') {
            return None;
        }
        let next = numbers.len() + 1;
        let number = *numbers.entry(name.to_vec()).or_insert(next);
        pdf[digits].copy_from_slice(format!("{number:0DIGITS$}").as_bytes());
    }
    let mut sorted: Vec<&[u8]> = Vec::new();
    let mut rest = &pdf[entries.clone()];
    while !rest.is_empty() {
        let end = find(rest, b" R").filter(|_| rest.starts_with(NAME))? + 2;
        sorted.push(&rest[..end]);
        rest = rest[end..].trim_ascii_start();
    }
    sorted.sort_unstable();
    let ends = [sorted.first()?.get(..WHOLE_NAME)?, sorted.last()?.get(..WHOLE_NAME)?].join(&b' ');
    let sorted = sorted.join(&b' ');
    if (sorted.len(), ends.len()) != (entries.len(), limits.len()) {
        return None;
    }
    pdf[entries].copy_from_slice(&sorted);
    pdf[limits].copy_from_slice(&ends);
    Some(pdf)
}

/// What stands behind a key to the next closing bracket, where the key is there once.
fn only(pdf: &[u8], key: &[u8]) -> Option<Range<usize>> {
    let [start] = places(pdf, key)[..] else { return None };
    let start = start + key.len();
    Some(start..start + find(&pdf[start..], b"]")?)
}

fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}

fn places(bytes: &[u8], wanted: &[u8]) -> Vec<usize> {
    let starts = bytes.windows(wanted.len()).enumerate();
    starts.filter(|(_, window)| *window == wanted).map(|(start, _)| start).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn repeatable(pdf: &str) -> String {
        let mut bytes = pdf.as_bytes().to_vec();
        make_repeatable(&mut bytes);
        assert_eq!(bytes.len(), pdf.len());
        String::from_utf8(bytes).unwrap()
    }

    #[test]
    fn the_time_of_printing_is_left_out_and_no_byte_moves() {
        let after =
            repeatable("<</Producer (Skia)\n/CreationDate (D:20261121234719+00'00')\n/ModDate (D:2026)>> (\\(D:1)");
        assert_eq!(after.split_whitespace().collect::<Vec<_>>(), ["<</Producer", "(Skia)", ">>", "(\\(D:1)"]);
    }

    #[test]
    fn headings_are_numbered_as_they_stand_whatever_a_browser_called_them() {
        let printed = |[column, other, row]: [u32; 3], index: &str| {
            let body = format!(
                "/ID (node{column:08})>> /ID (node{other:08})>> /ID (node{row:08})>> \
                 /Headers [(node{column:08}) (node{row:08})]>>"
            );
            repeatable(&format!("{body} <<{index}>>"))
        };
        let expected = printed(
            [1, 2, 3],
            "/Limits [(node00000001) (node00000003)]\n\
             /Names [(node00000001) 30 0 R (node00000002) 7 0 R (node00000003) 112 0 R]",
        );
        let otherwise = printed(
            [31, 4, 77],
            "/Limits [(node00000004) (node00000077)]\n\
             /Names [(node00000004) 7 0 R (node00000031) 30 0 R (node00000077) 112 0 R]",
        );
        assert_eq!(otherwise, expected);
        assert!(expected.contains("/Names [(node00000001) 30 0 R (node00000002) 7 0 R (node00000003) 112 0 R]"));
    }

    #[test]
    fn an_index_of_another_shape_is_left_alone() {
        let right = "/ID (node00000009) /Limits [(node00000009) (node00000009)] /Names [(node00000009) 30 0 R]";
        assert_ne!(repeatable(right), right);
        let wrong = |from: &str, to: &str| right.replacen(from, to, 1);
        for pdf in [
            right.replace("/Limits [(node00000009) (node00000009)] /Names [(node00000009) 30 0 R]", ""),
            right.replace("[(node00000009) (node00000009)]", "[]").replace("[(node00000009) 30 0 R]", "[]"),
            wrong("(node00000009) 30", "(other) 30"),
            wrong("30 0 R", "30"),
            wrong("30 0 R", "30  0 R\n"),
            wrong("30 0 R]", "30 0 R"),
            wrong("(node00000009)]", "(node00000009) (node00000009)]"),
            right.replace("node00000009", "node9"),
            right.replace("node00000009", "node000000009"),
            format!("{right} (node"),
            format!("{right} {right}"),
        ] {
            assert_eq!(repeatable(&pdf), pdf);
        }
    }
}
