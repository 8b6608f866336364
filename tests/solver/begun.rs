//! A scene followed piece by piece, as sets of numbers are, against the same scene solved as a whole.

use std::sync::Arc;

use carom::bank::{read_question, shipped};
use carom::diagnostic::Source;
use carom::generate::reference;
use carom::mechanics::Quantity;
use carom::solve::{Begun, solve};

/// In whatever order it is asked, and whatever has been derived before: what is found is what the whole solution has, to the
/// last step.
#[test]
fn to_be_followed_piece_by_piece_changes_nothing() {
    let mut followed = 0;
    for (id, text) in shipped() {
        let question = read_question(id, &Source::new(id, text)).unwrap_or_else(|_| panic!("{id}"));
        let scene = reference(&question).unwrap_or_else(|_| panic!("{id}")).scene;
        let wanted: Vec<Quantity> = question.styles.iter().flat_map(|style| question.wanted(style)).collect();
        let Some(mut begun) = Begun::new(Arc::clone(&scene)).unwrap() else { continue };
        let whole = solve(scene, &wanted).unwrap();
        for quantity in wanted.iter().rev() {
            begun.derive(&[*quantity]);
            assert_eq!(begun.number(*quantity), whole.number(*quantity), "{id}: {quantity}");
            assert_eq!(begun.angle(*quantity), whole.angle(*quantity), "{id}: {quantity}");
        }
        let solved = begun.solve(&wanted).unwrap();
        assert_eq!(solved.derivation(), whole.derivation(), "{id}");
        assert_eq!(solved.known(), whole.known(), "{id}");
        assert_eq!(solved.selection(), whole.selection(), "{id}");
        followed += 1;
    }
    assert!(followed > 20, "only {followed}");
}
