//! A requirement for the author to add: one between the numbers given that turns away what cannot be posed and nothing else.

use crate::bank::{Question, Style};
use crate::expr::{number, print};
use crate::generate::{Further, Numbers, Sieve, Unfit};

/// So many sets of numbers are looked at.
const MOST: u64 = 20_000;

/// A number as it is written, and its size.
type Given = (String, f64);

/// A set of numbers; can it be posed?
struct Tried {
    numbers: Vec<Given>,
    is_possible: bool,
}

/// What an author may add to `require`, where something does.
pub fn help(question: &Question, style: &Style, reason: &Unfit) -> Option<String> {
    let wanted = requirement(question, style, reason)?;
    let of = if style.size() <= MOST { "" } else { ", of the sets that were tried" };
    Some(format!("add `\"{wanted}\"` to `require`, which turns these away and no others{of}"))
}

/// The shortest inequality that holds of the sets that can be posed, and of none that a reason turns away: two numbers
/// beside each other, one beside a value, or a product beside a number, as in `e*mB > mA`.
fn requirement(question: &Question, style: &Style, reason: &Unfit) -> Option<String> {
    let tried = tried(question, style, reason);
    if tried.is_empty() {
        // Of nothing everything is true.
        return None;
    }
    let names: Vec<&str> = style.parameters.iter().map(|(name, _)| name.as_str()).collect();
    let separates = |sides: &dyn Fn(&[Given]) -> [f64; 2], is_strict: bool| {
        tried.iter().all(|set| {
            let [large, small] = sides(&set.numbers);
            let is_near = (large - small).abs() < 1e-9;
            (if is_near { !is_strict } else { large > small }) == set.is_possible
        })
    };
    let sign = |is_strict| if is_strict { ">" } else { ">=" };
    let all = || 0..names.len();
    let pairs = || all().flat_map(|one| all().map(move |other| (one, other))).filter(|(one, other)| one != other);
    for is_strict in [true, false] {
        for (one, other) in pairs() {
            if separates(&|set| [set[one].1, set[other].1], is_strict) {
                return Some(format!("{} {} {}", names[one], sign(is_strict), names[other]));
            }
        }
    }
    let possible = || tried.iter().filter(|set| set.is_possible).map(|set| &set.numbers);
    for one in all() {
        let by_size = |a: &&Vec<Given>, b: &&Vec<Given>| a[one].1.total_cmp(&b[one].1);
        let (least, most) = (possible().min_by(by_size)?, possible().max_by(by_size)?);
        if separates(&|set| [set[one].1, least[one].1], false) {
            return Some(format!("{} >= {}", names[one], least[one].0));
        }
        if separates(&|set| [most[one].1, set[one].1], false) {
            return Some(format!("{} <= {}", names[one], most[one].0));
        }
    }
    for is_strict in [true, false] {
        for ((one, other), third) in pairs().flat_map(|pair| all().map(move |third| (pair, third))) {
            let product = |set: &[Given]| set[one].1 * set[other].1;
            if one > other || third == one || third == other {
                continue;
            }
            let (factors, alone) = (format!("{}*{}", names[one], names[other]), names[third]);
            if separates(&|set| [product(set), set[third].1], is_strict) {
                return Some(format!("{factors} {} {alone}", sign(is_strict)));
            }
            if separates(&|set| [set[third].1, product(set)], is_strict) {
                return Some(format!("{alone} {} {factors}", sign(is_strict)));
            }
        }
    }
    None
}

/// Sets of numbers from all of the style that meet what is required of them; none where some number is no number, or only
/// one kind is there.
fn tried(question: &Question, style: &Style, reason: &Unfit) -> Vec<Tried> {
    let sieve = Sieve::new(question, style);
    let size = style.size();
    let mut tried = Vec::new();
    for nth in 0..size.min(MOST) {
        let index = if size <= MOST { nth } else { (u128::from(nth) * u128::from(size) / u128::from(MOST)) as u64 };
        let numbers = Numbers::new(&sieve, index);
        if let Err((Unfit::Givens(_) | Unfit::NoValue, _)) = numbers.examine(&sieve, Further::Never) {
            continue;
        }
        let is_possible = match numbers.posed() {
            Ok(_) => true,
            Err(other) if other == *reason => false,
            Err(_) => continue,
        };
        let size = |(_, expr): &(String, _)| Some((print::plain(expr), number(expr, &|_| None).ok()?.to_f64()?));
        let Some(numbers) = style.parameters_at(index).iter().map(size).collect() else { return Vec::new() };
        tried.push(Tried { numbers, is_possible });
    }
    let has_both = [true, false].iter().all(|is_possible| tried.iter().any(|set| set.is_possible == *is_possible));
    if has_both { tried } else { Vec::new() }
}
