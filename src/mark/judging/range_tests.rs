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
        ("1/3 < e <= 1", "", "3e > 1", Partial, Some("range-unsolved")),
        ("1/3 < e <= 1", "", "1 - 3e < 0", Partial, Some("range-unsolved")),
        ("1/3 < e <= 1", "", "5(1 - 3e)/14 < 0", Partial, Some("range-unsolved")),
        ("1/3 < e <= 1", "", "1 - 3e < 0 so e > 1/3", Correct, None),
        ("1/3 < e <= 1", "", "1/3 < e ≤ 2", Partial, Some("range-too-far")),
        ("1/3 < e <= 1", "", "e > 1/3, e < 1.5", Partial, Some("range-too-far")),
        ("1/3 < e <= 1", "", "e > 1/3, e < 1.5, e ≤ 1", Correct, None),
        ("1/3 < e <= 1", "", "(1/3, 1]", Correct, None),
        ("1/3 < e <= 1", "", "e ∈ (1/3, 1]", Correct, None),
        ("1/3 < e <= 1", "", r"$e \in \left(\frac{1}{3}, 1\right]$", Correct, None),
        ("1/3 < e <= 1", "", "]1/3, 1]", Correct, None),
        ("1/3 < e <= 1", "", "]1/3; 1[", Correct, None),
        ("1/3 < e <= 1", "", "(1/3, 1)", Correct, None),
        ("1/3 < e <= 1", "", "[1/3, 1]", Partial, Some("range-end")),
        ("1/3 < e <= 1", "", "(1/3, 2]", Partial, Some("range-too-far")),
        ("1/3 < e <= 1", "", "(1, 1/3]", Wrong, Some("range-turned")),
        ("1/3 < e <= 1", "", "k ∈ (1/3, 1]", Unreadable, Some("cannot-be-compared")),
        ("1/3 < e <= 1", "", "{e : 1/3 < e ≤ 1}", Correct, None),
        ("1/3 < e <= 1", "", r"\{e | e > 1/3, e \leq 1\}", Correct, None),
        ("1/3 < e <= 1", "", "e between 1/3 and 1", Partial, Some("range-end")),
        ("1/3 < e <= 1", "", "e > 1/3 (up to 1)", Correct, None),
        ("1/3 < e <= 1", "", "e exceeds 1/3", Correct, None),
        ("1/3 < e <= 1", "", "{e ∈ ℝ : 1/3 < e ≤ 1}", Correct, None),
        ("1/3 < e <= 1", "", "e > 1/3 ∩ e ≤ 1", Correct, None),
        ("1/3 < e <= 1", "", "any value more than 1/3", Correct, None),
        ("1/3 < e <= 1", "", "any e bigger than 1/3", Correct, None),
        ("1/3 < e <= 1", "", "e > 1/3, e can't be more than 1", Correct, None),
        ("1/3 < e <= 1", "", "e can't be more than 1/3", Wrong, Some("range-turned")),
        ("0 < k <= 1", "", "k up to and including 1", Correct, None),
        ("1/3 < e <= 1", "", "e > 1/3 or e < 1/4", Wrong, None),
        ("1/3 < e <= 1", "", "e > 1/3 but at most 1", Correct, None),
        ("2 <= k <= 3", "", "[2, 3]", Correct, None),
        ("2 <= k <= 3", "", "(2, 3)", Partial, Some("range-end")),
        ("2 <= k <= 3", "", "[2, 4]", Wrong, None),
        ("2 <= k <= 3", "", "2 ≤ k ≤ 4", Wrong, None),
        ("2 <= k <= 3", "", "2 - 3", Unreadable, Some("cannot-be-compared")),
        ("2 <= k <= 3", "", "2 to 3 inclusive", Correct, None),
        ("2 <= k <= 3", "", "2 to 3", Partial, Some("range-wanted")),
        ("2 <= k <= 3", "", "k in [2, 3]", Correct, None),
        ("2 <= k <= 3", "", "k in [2, 3)", Partial, Some("range-end")),
        ("2 <= k <= 3", "", "k is between 2 and 3, both included", Correct, None),
        ("2 <= k <= 3", "", "the set of values is 2 ≤ k ≤ 3", Correct, None),
        ("2 <= k <= 3", "", "2 - 4", Wrong, Some("not-a-range")),
        ("1/3 < e <= 1", "", "1/3 – 1", Unreadable, Some("cannot-be-compared")),
        ("2 <= k <= 3", "", "2 ≤ k ≤ 3", Correct, None),
        ("2 <= k <= 3", "", "1 ≥ k - 2 ≥ 0", Partial, Some("range-unsolved")),
        ("2 <= k <= 3", "", "k from 2 to 3", Partial, Some("range-end")),
        ("2 <= k <= 3", "", "k lies between 2 and 3 (inclusive)", Correct, None),
        ("2 <= k <= 3", "", "between 2 and 3 inclusive", Correct, None),
        ("2 <= k <= 3", "", "k is at least 2 and at most 3", Correct, None),
        ("2 <= k <= 3", "", "k ≥ 2 and ≤ 3", Correct, None),
        ("2 <= k <= 3", "", "k ≤ 2 or k ≥ 3", Wrong, Some("range-turned")),
        ("k > 2", "", "(2, ∞)", Correct, None),
        ("k > 2", "", "(2, infinity)", Correct, None),
        ("k > 2", "", "2 < k‹∞", Correct, None),
        ("k > 2", "", "2 < k > ∞", Unreadable, Some("cannot-be-read")),
        ("k > 2", "", "(∞, 2)", Unreadable, Some("cannot-be-read")),
        ("k > 2", "", "more than 2", Correct, None),
        ("k > 2", "", "k must be strictly greater than 2", Correct, None),
        ("k > 2", "", "at least 2", Partial, Some("range-end")),
        ("k > 2", "", "less than 2", Wrong, Some("range-turned")),
        ("0 < k <= 1", "", "k does not exceed 1", Correct, None),
        ("1/3 < e <= 1", "", "e is greater than 1/3 but cannot exceed 1", Correct, None),
        ("0 < k <= 1", "", "-1 < k ≤ 1", Partial, Some("range-too-far")),
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
        ("1/3 < e <= 1", "", "between 1/3 (excluded) and 1", Unreadable, Some("cannot-be-compared")),
        ("k >= 2", "", "2 or more", Correct, None),
        ("k >= 2", "", "k is 2 or above", Correct, None),
        ("k >= 2", "", "k = 2 and above", Correct, None),
        ("k > 2", "", "2 or more", Partial, Some("range-end")),
        ("k >= 2", "", "2 or less", Wrong, Some("range-turned")),
        ("k >= 2", "", "k > 2 or more", Unreadable, Some("cannot-be-read")),
        ("2 <= k < 3", "", "k from 2 up to 3 but not including 3", Correct, None),
        ("2 <= k < 3", "", "k from 2 up to 3 but not including 2", Partial, Some("range-end")),
        ("2 <= k < 3", "", "k from 2 up to 3 but not including 4", Partial, Some("range-end")),
        ("1/3 < e <= 1", "", "from 1/3 up to 1 but not including 1/3", Correct, None),
        ("1/3 < e <= 1", "", "e over 1/3", Unreadable, Some("cannot-be-compared")),
        ("1/3 < e <= 1", "", "e 1/3", Unreadable, Some("cannot-be-read")),
        ("1/3 < e <= 1", "", "3e - 1, e > 1/3", Unreadable, Some("cannot-be-compared")),
        ("1/3 < e <= 1", "", "from 1/3 up to 1, but not including 1", Unreadable, Some("cannot-be-read")),
        ("1/3 < e <= 1", "", "from 1/3 up to 1 but not including 1", Partial, Some("range-end")),
        ("1/3 < e <= 1", "", "e > 1/3 up to but not including 1", Unreadable, Some("cannot-be-read")),
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
        ("k > 2/3", "", "k > 0.8/1.2 = 2/3", Correct, None),
        ("k > 2/3", "", "2/3 = 4/6 < k", Correct, None),
        ("k > 2/3", "", "k > 2/3 = 0.67", Correct, None),
        ("k > 2/3", "", "k > 0.667 = 2/3", Correct, None),
        ("k > 2/3", "", "k > 2/3 = 0.76", Unreadable, Some("cannot-be-compared")),
        ("k > 2/3", "", "k > 1/3 = 2/3", Unreadable, Some("cannot-be-compared")),
        ("k > 2/3", "", "k < 4/6 = 2/3", Wrong, Some("range-turned")),
        ("1/2 < k < 3", "", "4/8 = 1/2 < k < 6/2 = 3", Correct, None),
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

#[test]
fn a_range_is_no_answer_where_none_is_asked_for() {
    for (model, answer, verdict) in [("5", "(3, 4]", Verdict::Wrong), ("3", "more than 3", Verdict::Unreadable)] {
        let model = Model::read(model, &ModelOptions::default()).unwrap();
        assert_eq!(judge(&model, &read_answer(answer, &model.vocabulary)).verdict, verdict, "{answer}");
    }
}
