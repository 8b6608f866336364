//! Ranges, as students write them.

use super::{Model, ModelOptions, Verdict, judge};
use crate::answer::Kind;
use crate::mark::reading::read_answer;

#[test]
fn a_range_is_judged_by_its_ends() {
    use Verdict::{Correct, Partial, Unreadable, Wrong};
    let cases = [
        ("1/3 < e <= 1", "", "e > 1/3", Correct, None),
        ("1/3 < e <= 1", "", "1/3 < e", Correct, None),
        ("1/3 < e <= 1", "", "1/3<e≤1", Correct, None),
        ("1/3 < e <= 1", "", "1 ≥ e > 1/3", Correct, None),
        ("1/3 < e <= 1", "", "1/3 < e < 1", Correct, None),
        ("1/3 < e <= 1", "", "e > 1/3 and e <= 1", Correct, None),
        ("1/3 < e <= 1", "", "3e > 1", Correct, None),
        ("1/3 < e <= 1", "", "1 - 3e < 0", Correct, None),
        ("1/3 < e <= 1", "", r"$\frac13 < e \leq 1$", Correct, None),
        ("1/3 < e <= 1", "", "e ≥ 1/3", Partial, Some("range-end")),
        ("1/3 < e <= 1", "", "1/3", Partial, Some("range-wanted")),
        ("1/3 < e <= 1", "", "e = 1/3", Partial, Some("range-wanted")),
        ("1/3 < e <= 1", "", "1/2", Wrong, Some("not-a-range")),
        ("1/3 < e <= 1", "", "1", Wrong, Some("range-wanted")),
        ("1/3 < e <= 1", "", "1/3, 1/2", Wrong, Some("not-a-range")),
        ("k > 2", "", "1/3", Wrong, Some("not-a-range")),
        ("k > 2", "", "k = 2", Partial, Some("range-wanted")),
        ("1/3 < e <= 1", "", "e < 1/3", Wrong, Some("range-turned")),
        ("1/3 < e <= 1", "", "e > 1/2", Wrong, None),
        ("1/3 < e <= 1", "", "1/3 < e < 0.9", Wrong, None),
        ("1/3 < e <= 1", "", "e > 0.333", Partial, Some("exact-wanted")),
        ("1/3 < e <= 1", "awrt 3sf", "e > 0.333", Correct, None),
        ("1/3 < e <= 1", "awrt 3sf", "e > 0.33", Partial, Some("under-accurate")),
        ("1/3 < e <= 1", "", "k > 1/3", Unreadable, Some("cannot-be-read")),
        ("k > 2", "", "k > 2", Correct, None),
        ("k > 2", "", "2 < k", Correct, None),
        ("k > 2", "", "k > 2, k = 5", Wrong, Some("rival-answers")),
        ("k > 2", "", "k = 5, k > 2", Wrong, Some("rival-answers")),
        ("k > 2", "", "k > 2, 7", Wrong, Some("rival-answers")),
        ("k > 2", "", "k > 2 and k = 2", Partial, Some("range-end")),
        ("k > 2", "", "k > 3, k = 5", Wrong, None),
        ("k > 2", "", "k >= 2, k = 5", Wrong, Some("rival-answers")),
        ("k > 2", "", "3k > 6 so k > 2", Correct, None),
        ("k > 2", "", "k - 2 > 0 => k > 2", Correct, None),
        ("k > 2", "", "k > 2 and k > 1", Correct, None),
        ("k > 2", "", "k > 1, k > 2", Correct, None),
        ("k > 2", "", "k > 2 and k > 3", Wrong, None),
        ("k > 2", "", "k > 2 and k < 3", Wrong, None),
        ("k > 2", "", "k > 2 and k < 1", Wrong, None),
        ("k > 2", "", "k > 1", Wrong, None),
        ("k > 2", "", "k > 2 so k >= 2", Partial, Some("range-end")),
        ("k > 2", "", "k >= 2 so k > 2", Partial, Some("range-end")),
        ("k > 2/3", "", "k > 2/3 so k > 0.667", Correct, None),
        ("k > 2/3", "", "k > 0.667 so k > 2/3", Correct, None),
        ("k > 2", "", "k >= 2", Partial, Some("range-end")),
        ("1/2 < k < 3", "", "1/2 < k < 3", Correct, None),
        ("1/2 < k < 3", "", "k > 0.5, k < 3", Correct, None),
        ("1/2 < k < 3", "", "2k > 1, k > 1/2, k < 3, k < 4", Correct, None),
        ("1/2 < k < 3", "", "k < 3, k < 4", Partial, Some("range-half")),
        ("1/2 < k < 3", "", "k < 3, k = 2", Wrong, Some("rival-answers")),
        ("1/2 < k < 3", "", "k < 3", Partial, Some("range-half")),
        ("1/2 < k < 3", "", "1/2 <= k < 3", Partial, Some("range-end")),
        ("0 < k <= 1", "", "k <= 1", Correct, None),
        ("0 < k <= 1", "", "0 < k ≤ 1", Correct, None),
        ("0 < k <= 1", "", "0 ≤ k ≤ 1", Correct, None),
    ];
    for (model, accept, answer, verdict, note) in cases {
        let accept = (!accept.is_empty()).then(|| accept.parse().unwrap());
        let options = ModelOptions { kind: Some(Kind::Range), accept, ..ModelOptions::default() };
        let model_read = Model::read(model, &options).unwrap_or_else(|fault| panic!("{model}: {}", fault.message));
        let judged = judge(&model_read, &read_answer(answer, &model_read.vocabulary));
        assert_eq!((judged.verdict, judged.note), (verdict, note), "{model}: {answer}");
    }
}

#[test]
fn what_is_no_range_is_refused_as_a_model() {
    let options = ModelOptions { kind: Some(Kind::Range), ..ModelOptions::default() };
    for model in ["1/3", "1 < e <", "1 < e < 2 < 3", "<"] {
        assert!(Model::read(model, &options).is_err(), "{model}");
    }
}
