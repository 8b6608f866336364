//! A vector that a student gives by letters for its components, `v = xi + yj`, and of which the letters are found later: `x = -1,
//! y = 4` says then what the vector is.

/// The vector, by its name, of which the last of these lines finds both components, or of which it and the line before find
/// one each.
pub(super) fn put_together(lines: &[&str]) -> Option<String> {
    let (last, before) = lines.split_last()?;
    let (name, [x, y]) = before.iter().rev().find_map(|line| declared(line))?;
    let both = match (values(last, [&x, &y]), before.last().map(|line| values(line, [&x, &y]))) {
        ([Some(x), Some(y)], _) => [x, y],
        ([None, Some(y)], Some([Some(x), None])) => [x, y],
        ([Some(x), None], Some([None, Some(y)])) => [x, y],
        _ => return None,
    };
    let [x, y] = both;
    Some(format!("{name} = ({x})i + ({y})j"))
}

/// `let v = xi + yj`: the name, and the letters of the components.
fn declared(line: &str) -> Option<(String, [String; 2])> {
    let (before, after) = line.split_once('=')?;
    let name = before.split_whitespace().next_back()?;
    let vector: String = after.trim_end_matches('.').chars().filter(|sign| !matches!(sign, ' ' | '*' | '·')).collect();
    let (first, second) = vector.split_once('+')?;
    let letter = |term: &str, unit: char| {
        let letter = term.strip_suffix(unit)?;
        let mut signs = letter.chars();
        let is_letter = signs.next().is_some_and(|sign| sign.is_alphabetic() && !matches!(sign, 'i' | 'j'));
        (is_letter && signs.next().is_none()).then(|| letter.to_owned())
    };
    let letters = [letter(first, 'i')?, letter(second, 'j')?];
    (letters[0] != letters[1]).then(|| (name.to_owned(), letters))
}

fn values<'l>(line: &'l str, letters: [&str; 2]) -> [Option<&'l str>; 2] {
    letters.map(|letter| value_of(line, letter))
}

/// What a line sets a letter equal to, where it only lists such values.
fn value_of<'l>(line: &'l str, letter: &str) -> Option<&'l str> {
    let clauses = move || line.trim_end_matches('.').split([',', ';']).flat_map(|clause| clause.split(" and "));
    let parts = |clause: &'l str| clause.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
    let is_value = |clause: &'l str| parts(clause).is_some_and(|(_, value)| !value.is_empty() && !value.contains('='));
    let name = |name: &str| name.split_whitespace().next_back() == Some(letter);
    clauses().all(is_value).then(|| clauses().filter_map(parts).find(|(own, _)| name(own)))?.map(|(_, value)| value)
}

#[cfg(test)]
mod tests {
    use super::put_together;

    #[test]
    fn components_by_their_letters_make_the_vector() {
        let made = |working: &str| put_together(&working.lines().collect::<Vec<_>>());
        let vector = Some("v = (-1)i + (4)j".to_owned());
        assert_eq!(made("Let v = xi + yj\n2x = -2\nx = -1, y = 4"), vector);
        assert_eq!(made("v = x i + y j\nx = -1\nso y = 4."), vector);
        assert_eq!(made("v = ai + bj\nb = 4\na = -1"), vector);
        for other in
            ["x = -1, y = 4", "v = xi + yj\nx = -1", "v = xi + yj\nx + y = 3\ny = 4", "v = xi + xj\nx = 1, x = 2"]
        {
            assert_eq!(made(other), None, "{other}");
        }
    }
}
