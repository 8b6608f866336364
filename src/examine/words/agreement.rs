//! Do the words of a sentence agree in number: `two spheres` with two names, `the spheres are`, `a sphere`, `masses 2 kg
//! and 3 kg`?

use super::grammar::{Count, JOINING, body, counted, determiner, ends_a_phrase, noun, other_number};
use super::phrases::{is_bound, noun_after, row};
use super::sentence::{Sentence, Token, is_one_of, says, sentences};
use super::sentences::remark_at;
use super::verbs::{verb_of_a_clause, verb_of_which};
use crate::examine::remark::Remark;
use crate::expr::{Expr, Text};
use crate::mechanics::Sphere;

/// Counts, articles, verbs and pronouns that are of another number than their nouns.
pub fn disagreeing(text: &Text, remarks: &mut Vec<Remark>) {
    for sentence in sentences(text) {
        for place in 0..sentence.len() {
            let rules =
                [miscounted, counted_otherwise, of_one_number, unbound, verb_of_a_clause, verb_of_which, possessive];
            rules.into_iter().for_each(|rule| rule(&sentence, place, remarks));
        }
    }
}

/// The word at a place; none of its own for a name, a number or a comma.
pub(super) fn word_at<'s>(sentence: &'s Sentence, at: usize) -> &'s str {
    match sentence.get(at) {
        Some(Token::Word(word)) => word,
        _ => "",
    }
}

/// A word with the one after it, so that no other place is taken for it.
pub(super) fn pair(sentence: &Sentence, at: usize) -> String {
    let words = sentence[at..].iter().take(2).map_while(|token| match token {
        Token::Word(word) => Some(word.as_str()),
        _ => None,
    });
    words.collect::<Vec<_>>().join(" ")
}

/// What a sentence writes for a word, which begins with a capital where the sentence does.
fn written(sentence: &Sentence, at: usize) -> String {
    let word = word_at(sentence, at);
    let first = word.chars().next().filter(|_| at == 0);
    first.map_or_else(|| word.to_owned(), |first| format!("{}{}", first.to_uppercase(), &word[first.len_utf8()..]))
}

/// `Three spheres *A* and *B*`.
fn miscounted(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    let Token::Word(word) = &sentence[place] else { return };
    let Some(said) = ["two", "three"].iter().position(|count| count == word).map(|nth| nth + 2) else { return };
    let Some(noun) = noun_after(sentence, place).filter(|noun| body(word_at(sentence, *noun)) == Some(Count::Several))
    else {
        return;
    };
    let Some((_, named)) = row(sentence, noun + 1) else { return };
    // `Two spheres *A*, of mass 2 kg, and *B*` names them one by one.
    let all = Sphere::ALL.into_iter().filter(|sphere| sentence[place..].contains(&Token::Sphere(*sphere))).count();
    if named != said && all != said {
        let count = if named == 1 { "one is named".to_owned() } else { format!("{named} are named") };
        let what = format!("{word} of which {count}");
        let help = "name as many as there are, or say another number";
        let (at, shown) = (pair(sentence, noun - 1), format!("{word} … {}", word_at(sentence, noun)));
        remarks.push(remark_at(&what, &at, &shown, help));
    }
}

/// `A small smooth spheres`, `two sphere`, `1 metres`.
fn counted_otherwise(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    const COUNTS: [&str; 5] = ["few", "pair", "couple", "further", "both"];
    let word = word_at(sentence, place);
    let Some(said) = determiner(word) else { return };
    // `Three times the mass`
    if word_at(sentence, place + 1) == "times" {
        return;
    }
    let is_number = word.starts_with(|sign: char| sign.is_ascii_digit());
    let before = place.checked_sub(1).map_or("", |before| word_at(sentence, before));
    // `Sphere 2`, `part 2`: a number after what it tells from others.
    if is_number && (noun(before).is_some() || ["part", "figure", "question", "method"].contains(&before)) {
        return;
    }
    // `1 metres away` is amiss whatever follows, and `2 metre` may describe what does.
    let stands = |at: usize| match counted(word_at(sentence, at)) {
        Some(Count::Several) => said == Count::One,
        Some(Count::One) => {
            sentence.get(at + 1).is_none_or(|next| !is_word(next) || ends_a_phrase(word_at(sentence, at + 1)))
        }
        None => false,
    };
    let beside = Some(place + 1).filter(|at| stands(*at));
    let Some(at) = noun_after(sentence, place).or(beside) else { return };
    let between = &sentence[place + 1..at];
    let is_counted_again = between
        .iter()
        .any(|token| is_one_of(token, &COUNTS) || matches!(token, Token::Word(word) if determiner(word).is_some()));
    let noun = word_at(sentence, at);
    // `unchanged for both (impulse is parallel to {j})` has a bracket there.
    let is_each = word == "both" && (says(&sentence[at..], &["and"]) || body(noun).is_none());
    if is_counted_again || is_each || counted(noun) == Some(said) {
        return;
    }
    let gap = if between.is_empty() { " " } else { " … " };
    let (what, help) = match said {
        Count::One => ("one of several", "write the word in the singular, or say how many"),
        Count::Several => ("several of one", "write the word in the plural"),
    };
    let from = if at > place + 1 { at - 1 } else { at };
    let shown = format!("{}{gap}{noun}", written(sentence, place));
    remarks.push(remark_at(what, &pair(sentence, from), &shown, help));
}

/// Is it a word, and no name, number or comma?
pub(super) fn is_word(token: &Token) -> bool {
    matches!(token, Token::Word(_))
}

/// `Have mass 2 kg and 3 kg`.
fn of_one_number(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    const OF_EACH: [&str; 5] = ["mass", "speed", "velocity", "radius", "angle"];
    let word = word_at(sentence, place);
    if !OF_EACH.contains(&word) {
        return;
    }
    let is_value = |token: &Token| matches!(token, Token::Number(expr, ..) if !matches!(expr, Expr::Relation(..)));
    let start = place + 1 + usize::from(word_at(sentence, place + 1) == "of");
    let listed = sentence[start..].iter().take_while(|token| is_value(token) || matches!(token, Token::Comma));
    let first = start + listed.count();
    let unit = |at: usize| match sentence.get(at) {
        Some(Token::Number(_, unit, _)) => Some(*unit),
        _ => None,
    };
    let is_list = unit(start) == unit(first + 1)
        && first > start
        && sentence[start..first].last().is_some_and(is_value)
        && word_at(sentence, first) == "and";
    if !is_list || !sentence.get(first + 1).is_some_and(is_value) {
        return;
    }
    // `Of mass 2 kg, and k is a constant` goes on with something else.
    let ends = match sentence.get(first + 2) {
        Some(Token::Word(next)) => {
            let next = next.as_str();
            next != "of" && (JOINING.contains(&next) || ["respectively", "each"].contains(&next))
        }
        Some(Token::Comma) | None => true,
        _ => false,
    };
    if let Some(several) = other_number(word).filter(|_| ends) {
        let at = if place > 0 && is_word(&sentence[place - 1]) { place - 1 } else { place };
        let shown = format!("{word} … and …");
        remarks.push(remark_at("one of several", &pair(sentence, at), &shown, &format!("write `{several}`")));
    }
}

/// `The spheres *A*, *B* have`.
fn unbound(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    let Some((end, named)) = row(sentence, place + 1) else { return };
    let is_several = body(word_at(sentence, place)) == Some(Count::Several);
    let goes_on = if sentence.get(end) == Some(&Token::Comma) { end + 1 } else { end };
    let is_left_open = match sentence.get(goes_on) {
        Some(Token::Word(word)) => goes_on == end || ["of", "with", "each"].contains(&word.as_str()),
        next => next.is_none(),
    };
    if is_several && is_left_open && named > 1 && !is_bound(sentence, place + 1, end) {
        let names: Vec<&str> = sentence[place + 1..end].iter().filter_map(name).collect();
        let (last, others) = names.split_last().map_or(("", &[][..]), |(last, others)| (*last, others));
        if others.len() + 1 == named {
            let help = format!("write `*{}* and *{last}*`", others.join("*, *"));
            let shown = format!("{} {}", word_at(sentence, place), names.join(", "));
            let at = format!("{} *{}*, *", word_at(sentence, place), others.join("*, *"));
            remarks.push(remark_at("a row of names without `and`", at.trim_end_matches(" *"), &shown, &help));
        }
    }
}

fn name<'t>(token: &Token<'t>) -> Option<&'static str> {
    if let Token::Sphere(sphere) = token { Some(sphere.name()) } else { None }
}

/// `The spheres change its directions`, with nothing before it of which there is one; `a sphere *A* moves along their path`.
fn possessive(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    if word_at(sentence, place) != "its" {
        return;
    }
    const OF_NOBODY: [&str; 6] = ["plane", "floor", "table", "surface", "collision", "impact"];
    let (mut at, mut has_several) = (0, false);
    while at < place {
        if let Some((end, named)) = row(sentence, at) {
            if named == 1 {
                return;
            }
            (at, has_several) = (end, true);
            continue;
        }
        match noun(word_at(sentence, at)) {
            Some(Count::Several) => has_several = true,
            Some(Count::One) if !OF_NOBODY.contains(&word_at(sentence, at)) => return,
            None if ["it", "each", "one", "another", "other", "either", "which"].contains(&word_at(sentence, at)) => {
                return;
            }
            _ => {}
        }
        at += 1;
    }
    if has_several {
        remarks.push(remark_at("a word of one for several", &pair(sentence, place), "several … its", "write `their`"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::read_markup;

    #[test]
    fn one_is_not_several() {
        let table = [
            ("Two small smooth spheres *A* and *B* have equal radii.", ""),
            ("A sphere *A*, of mass {m}, and a sphere *B*, of the same radius as *A*, moving at {u}, collide.", ""),
            ("Two smooth spheres *A*, *B* and *C* lie in a line.", "two of which 3 are named"),
            ("Two smooth spheres *A*, of mass {m}, and *B*, of mass {k}, have equal radii.", ""),
            ("Two balls *A* (mass {m}) and *B* (mass {k}) roll towards each other.", ""),
            ("Two smooth spheres *A*, of mass {m}, lie in a line.", "two of which one is named"),
            ("Three small smooth spheres *A* and *B*, of equal radius, lie in a line.", "three of which 2 are named"),
            ("Three spheres *A*, *B* and *C*, of masses {m}, {k} and {l}, are at rest.", ""),
            ("Two spheres lie between *A* and the wall.", ""),
            ("A small smooth spheres *A* moves.", "A … spheres"),
            ("A smooth sphere *A* strikes two walls.", ""),
            ("A sphere between two walls is at rest.", ""),
            ("The coefficient of restitution between the two spheres is {e}.", ""),
            ("The distance from *A* to *B* is {d}; the speed of *A* and *B* is {u}.", ""),
            ("The line joining *A* and *B* is parallel to {i}.", ""),
            ("The spheres is at rest.", "several … is"),
            ("*A* and *B* has equal radii.", "several spheres … has"),
            ("Two spheres *A* and *B*, of equal radii, is moving.", "several … is"),
            ("Two spheres *A* and *B*, of equal radii, are moving.", ""),
            ("*A* strikes *B* and is then at rest.", ""),
            ("As a result of the collision between *A* and *B* is turned the path of *A*.", ""),
            ("Sphere *A* hits *B*, which has mass {m}.", ""),
            ("Two small smooth sphere *A* and *B* move.", "Two … sphere"),
            ("The plane has 3 wall.", "3 wall"),
            ("*B* has three times the mass of *A*, and 2 times the speed.", ""),
            ("*B* has three times mass and 3 mass.", "3 mass"),
            ("It is 1 metres away.", "1 metres"),
            ("Sphere 2 wall 3 and part 2 sphere are names.", ""),
            ("A few spheres are at rest.", ""),
            ("These sphere are smooth.", "These sphere"),
            ("This spheres is smooth.", "This spheres"),
            ("Both sphere *A* and sphere *B* are smooth.", ""),
            ("Both the mass and the speed are doubled.", ""),
            ("{i} components unchanged for both (impulse is parallel to {j})", ""),
            ("A mass ratio of {k} is possible.", ""),
            ("The two velocity components are equal.", ""),
            ("Each sphere have mass {m}.", "one … have"),
            ("Each of the spheres have mass {m}.", "one … have"),
            ("Each of the spheres has mass {m}.", ""),
            ("The spheres collides directly.", "several … collides"),
            ("The mass of the spheres are {m}.", "one … are"),
            ("The masses of *A* and *B* is {m} and {k}.", "several … is"),
            ("The speed of *A* and the speed of *B* is {u} and {w}.", "several … is"),
            ("The speed of *A* and the speed of *B* are {u} and {w}.", ""),
            ("Sphere *A* and the wall is smooth.", "several … is"),
            ("The mass of the sphere and the speed of the ball are known.", ""),
            ("The radii is equal.", "several … is"),
            ("The radius of each sphere is {r}.", ""),
            ("The speeds of *A* and *B* before the collision are {u} and {w}.", ""),
            ("The speed of *A* immediately before the spheres collide is {u}.", ""),
            ("The speeds of *A* and *B* just before *A* strikes *B* are {u} and {w}.", ""),
            ("The speeds of *A* and *B* before *B* is struck are {u} and {w}.", ""),
            ("The component of the velocity of *A* along the line of centres after they collide is {u}.", ""),
            ("The speed of *A* before the collision are {u}.", "one … are"),
            ("The components of the velocity of *A* along the line of centres is {u}.", "several … is"),
            ("The line of centres of the spheres are parallel to {i}.", "one … are"),
            ("*A* collides with *B*, and then *B* strike the wall.", ""),
            ("After this *A* strikes *B* and then *C* strikes the wall.", ""),
            ("When *A* have struck *B*, they move on.", "one … have"),
            ("They collides.", "several … collides"),
            ("Find the speed with which the spheres moves.", "several … moves"),
            ("After the spheres collides, *A* is at rest.", "several … collides"),
            ("After the collision, the spheres moves on.", "several … moves"),
            ("After the collision, *A* have speed {u}.", "one … have"),
            ("If *B* were at rest, it would move.", ""),
            ("Does *A* strike the wall? It is given that it will make *A* move.", ""),
            ("Find the value of {k} for which *B* collide with *A*.", "one … collide"),
            ("Find the values of {k} for which *B* collides with *A*.", ""),
            ("*A* strikes a sphere *B* of mass {m}, which are at rest.", "one … are"),
            ("*A* strikes a sphere *B*, of mass {m}, which are at rest.", "one … are"),
            ("*A* strikes *B* with the masses of both doubled, which is impossible.", ""),
            ("The masses of *A* and *B*, which are equal, are {m}.", ""),
            ("The line of the spheres, which are smooth, is straight.", ""),
            ("*A* and a sphere *B*, which are smooth, collide.", ""),
            ("*A* and *B* have mass {m kg} and {k kg} respectively.", "mass … and …"),
            ("*A* and *B* have mass {m kg} and move with speed {u} and {w}.", "speed … and …"),
            ("*A* has mass {m kg} and {k} is a constant.", ""),
            ("*A* has mass {m kg} and *B* {k kg}.", ""),
            ("*A* moves with speed {u} and {tan(a) = 3/4}.", ""),
            ("*A* and *B* have masses {m}, {k} and speeds {u}, {w}.", ""),
            ("Two smooth spheres *A*, *B* have equal radii.", "spheres A, B"),
            ("Two smooth spheres *A*, *B*, of masses {m} and {k}, have equal radii.", "spheres A, B"),
            ("Three spheres *A*, *B* and *C*, of masses {m}, {k} and {l}, lies in a line.", "several … lies"),
            ("Three spheres *A*, *B* and *C*, of masses {m}, {k} and {l}, lie in a line.", ""),
            ("The sphere, of mass {m}, and its ball, of mass {k}, have equal radii.", ""),
            ("When it hits sphere *A*, *B* moves on.", ""),
            ("Three smooth spheres *A*, *B*, and *C* have equal radii.", ""),
            ("The spheres change its directions.", "several … its"),
            ("*A* and *B* move along its line of centres.", "several … its"),
            ("The spheres collide; *A* reverses its direction.", ""),
            ("The spheres lie on a line, and its direction is {i}.", ""),
            ("{m} and {e} is positive.", "several … is"),
            ("Here {m} and {e} are positive constants.", ""),
            ("The kinetic energy lost in the collision is {u}.", ""),
            ("The sum of the momenta of the spheres is unchanged, and so are the masses.", ""),
        ];
        let mut wrong = Vec::new();
        for (words, shown) in table {
            let mut remarks = Vec::new();
            for text in read_markup(words).unwrap() {
                disagreeing(&text, &mut remarks);
            }
            let said: Vec<&str> = remarks.iter().map(|remark| remark.shown.as_str()).collect();
            if said != (if shown.is_empty() { vec![] } else { vec![shown] }) {
                let what: Vec<&str> = remarks.iter().map(|remark| remark.what.as_str()).collect();
                if what.len() != 1 || !what[0].contains(shown) || shown.is_empty() {
                    wrong.push(format!("{words}: {said:?} {what:?}"));
                }
            }
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}
