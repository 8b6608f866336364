//! Which questions of a bank stand on a sheet: so many, or so many marks, drawn by the seed from every topic.

use std::collections::BTreeMap;

use crate::bank::Heading;
use crate::generate::Shuffle;

/// So many questions, in the order of the bank, topics as even as they come; past the number of questions they
/// repeat.
///
/// ```
/// use carom::bank::Contents;
/// use carom::paper::choose_count;
/// let contents = Contents::shipped();
/// let all: Vec<_> = contents.headings.iter().collect();
/// assert_eq!(choose_count(&all, 6, 1).len(), 6);
/// assert_eq!(choose_count(&all, 40, 1).len(), 40);
/// ```
pub fn choose_count<'h>(headings: &[&'h Heading], count: usize, seed: u64) -> Vec<&'h Heading> {
    let order = draw(headings, seed);
    let mut chosen: Vec<usize> = order.iter().cycle().take(if order.is_empty() { 0 } else { count }).copied().collect();
    chosen.sort_unstable();
    chosen.into_iter().map(|place| headings[place]).collect()
}

/// Different questions whose marks add up to as much as can be had without going over `marks`.
pub fn choose_marks<'h>(headings: &[&'h Heading], marks: usize, seed: u64) -> Vec<&'h Heading> {
    let order = draw(headings, seed);
    let whole: usize = order.iter().map(|place| headings[*place].marks).sum();
    let marks = marks.min(whole);
    // For each total the first way to reach it, questions tried in the order in which they were drawn.
    let mut ways: Vec<Option<Vec<usize>>> = vec![None; marks + 1];
    ways[0] = Some(Vec::new());
    for place in order {
        let own = headings[place].marks;
        for total in (own..=marks).rev() {
            if ways[total].is_none()
                && let Some(way) = &ways[total - own]
            {
                ways[total] = Some(way.iter().copied().chain([place]).collect());
            }
        }
    }
    let mut chosen = ways.into_iter().rev().flatten().next().unwrap_or_default();
    chosen.sort_unstable();
    chosen.into_iter().map(|place| headings[place]).collect()
}

/// The order in which questions are drawn: one of each topic, then a second of each, and so on.
fn draw(headings: &[&Heading], seed: u64) -> Vec<usize> {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    let mut drawn: Vec<(usize, usize)> = Shuffle::new(headings.len() as u64, seed, "", "questions")
        .map(|place| {
            let place = place as usize;
            let round = seen.entry(headings[place].topic.as_str()).or_default();
            *round += 1;
            (*round, place)
        })
        .collect();
    // Stable: within a round the order is that of the shuffle.
    drawn.sort_by_key(|(round, _)| *round);
    drawn.into_iter().map(|(_, place)| place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::Contents;

    #[test]
    fn the_first_questions_drawn_are_of_different_topics() {
        let contents = Contents::shipped();
        let all: Vec<&Heading> = contents.headings.iter().collect();
        for seed in 0..20 {
            let topics: std::collections::BTreeSet<&str> =
                choose_count(&all, 5, seed).iter().map(|heading| heading.topic.as_str()).collect();
            assert_eq!(topics.len(), 5);
        }
    }

    #[test]
    fn marks_are_reached_where_they_can_be() {
        let contents = Contents::shipped();
        let all: Vec<&Heading> = contents.headings.iter().collect();
        for seed in 0..20 {
            for marks in [20, 40, 75] {
                let total: usize = choose_marks(&all, marks, seed).iter().map(|heading| heading.marks).sum();
                assert_eq!(total, marks, "seed {seed}");
            }
        }
        assert!(choose_marks(&all, 1, 0).is_empty());
        assert_eq!(choose_marks(&all, 100_000, 0).len(), all.len());
    }
}
