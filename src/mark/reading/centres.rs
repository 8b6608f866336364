//! What the line of centres is called: `line through both centres`, `axis of the spheres`, `direction of the impulse`.

/// What a line is.
const LINES: [&str; 4] = ["line", "lines", "axis", "direction"];

/// Words that say how it lies, and do not change which it is.
const LYING: [&str; 4] = ["horizontal", "vertical", "straight", "same"];

/// Words between the line and what lies on it, of which the first alone join two spheres.
const JOINING: [&str; 10] =
    ["joining", "connecting", "linking", "through", "between", "containing", "joins", "connects", "links", "contains"];
const BETWEEN: [&str; 18] = [
    "of", "from", "in", "that", "which", "passes", "passing", "going", "goes", "run", "runs", "running", "both", "two",
    "each", "action", "along", "centre",
];
const ARTICLES: [&str; 6] = ["the", "their", "its", "this", "a", "an"];

/// What lies on the line of centres, or along it.
const ON_IT: [&str; 3] = ["centres", "impulse", "impulses"];
/// What lies on it, of which `direction` may be another.
const AT_ITS_ENDS: [&str; 8] = ["spheres", "balls", "particles", "impact", "impacts", "collision", "contact", "action"];

/// Words after which it is the line of something else: `line of the spheres' motion`.
const OF_MOTION: [&str; 7] = ["motion", "path", "paths", "velocity", "velocities", "travel", "movement"];

/// Every word of such a name.
pub(super) const WORDS: [&[&str]; 6] = [&LINES, &LYING, &JOINING, &BETWEEN, &ON_IT, &AT_ITS_ENDS];

/// Words with which such a name may begin.
pub(super) fn starts() -> impl Iterator<Item = &'static str> {
    LINES.into_iter().chain(LYING)
}

/// The line of centres described from word `at` on: the word after it.
pub(super) fn described<'w>(word: impl Fn(usize) -> Option<&'w str>, at: usize) -> Option<usize> {
    let is = |at: usize, choices: &[&str]| word(at).is_some_and(|word| choices.contains(&word));
    let noun = at + usize::from(is(at, &LYING));
    if !is(noun, &LINES) {
        return None;
    }
    let (mut is_direction, mut joins) = (is(noun, &["direction"]), false);
    let (mut next, mut end) = (noun + 1, None);
    loop {
        if joins && let Some(after) = two_spheres(&word, next) {
            (next, end) = (after, Some(after));
        } else if is(next, &ON_IT)
            || is(next, &["centre"]) && !is(next + 1, &["of"])
            || !is_direction && is(next, &AT_ITS_ENDS)
        {
            next += 1;
            end = Some(next);
        } else if end == Some(next) && is(next, &["acts", "act", "lie", "lies"]) {
            // `along which the impulse acts`
            next += 1;
            end = Some(next);
        } else if next == noun + 1 && is(next, &["a"]) && is(next + 1, &["b"]) {
            next += 2;
            end = Some(next);
        } else if is(next, &LINES) {
            // `direction of the line joining …`
            is_direction = is_direction && is(next, &["direction"]);
            next += 1;
        } else if is(next, &JOINING) || is(next, &BETWEEN) || is(next, &ARTICLES) {
            joins = joins || is(next, &JOINING);
            next += 1;
        } else {
            break;
        }
    }
    end.filter(|_| !is(next, &OF_MOTION))
}

/// `impulse`, `centres`, which are no name of the line but after `along` or `to`.
pub(super) fn on_it<'w>(word: impl Fn(usize) -> Option<&'w str>, at: usize) -> Option<usize> {
    let next = at + usize::from(word(at).is_some_and(|word| word == "both" || ARTICLES.contains(&word)));
    word(next).filter(|word| ON_IT.contains(word)).map(|_| next + 1)
}

/// `A and B`, `centre of A to centre of B`
fn two_spheres<'w>(word: &impl Fn(usize) -> Option<&'w str>, at: usize) -> Option<usize> {
    let is_word = |at: usize, wanted: &str| word(at) == Some(wanted);
    let centre_of = |at: usize| {
        let at = at + usize::from(is_word(at, "the"));
        if is_word(at, "centre") && is_word(at + 1, "of") { at + 2 } else { at }
    };
    let sphere = |at: usize| word(at).filter(|word| matches!(*word, "a" | "b" | "p" | "q"));
    let one = centre_of(at);
    let joiner = sphere(one).map(|_| one + 1).filter(|next| is_word(*next, "and") || is_word(*next, "to"))?;
    let other = centre_of(joiner + 1);
    (sphere(other)? != sphere(one)?).then_some(other + 1)
}

#[cfg(test)]
mod tests {
    use super::described;

    #[test]
    fn the_line_of_centres_has_many_names() {
        let named = "
            line of centres
            line of the centres
            line through both centres
            line that joins their centres
            line which passes through the centres of the spheres
            line joining A and B
            line joining the centre of A to the centre of B
            line of the spheres
            line between the two balls
            axis of centres
            line of the impulse
            direction of the impulse
            line of action of the impulse
            line of action
            line of impact
            horizontal line of centres
            direction of the line of centres
            line centres
            line of centre
            line of the centre
            line along which the impulse acts
            line A B";
        let others = "
            line
            direction
            line of motion
            line of the spheres' motion
            direction of the spheres
            direction of motion
            direction of the particles before the impact
            line A and B
            line of greatest slope
            horizontal line
            axis
            line from A to B";
        let whole = |name: &str| {
            let words: Vec<String> =
                name.to_lowercase().split([' ', '\'']).map(str::to_owned).filter(|word| !word.is_empty()).collect();
            described(|at| words.get(at).map(String::as_str), 0) == Some(words.len())
        };
        for name in named.lines().map(str::trim).filter(|name| !name.is_empty()) {
            assert!(whole(name), "`{name}` is the line of centres");
        }
        for name in others.lines().map(str::trim).filter(|name| !name.is_empty()) {
            assert!(!whole(name), "`{name}` is not the line of centres");
        }
    }
}
