//! Every mistake that is recognised, as the documentation lists it.

use crate::mechanics::{Law, Slip};

use super::{ARITHMETIC, calculator, last_step};

/// A mistake as the documentation lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listed {
    /// The tag.
    pub tag: &'static str,
    /// The law that owns it and the others that answer to it; of a slip of the calculator or of the last line none.
    pub laws: Vec<Law>,
    /// What the student did.
    pub did: &'static str,
    /// What a teacher would say.
    pub sentence: &'static str,
}

/// Every mistake that is recognised: those of laws and of the calculator in the order of their places, then those of the
/// last line.
pub fn all() -> Vec<Listed> {
    let of_laws =
        Slip::all().iter().map(|(law, slip)| (std::iter::once(*law).chain(slip.also.iter().copied()).collect(), *slip));
    let of_calculator = calculator::SLIPS.iter().map(|slip| (Vec::new(), slip));
    let mut slips: Vec<(Vec<Law>, &Slip)> = of_laws.chain(of_calculator).collect();
    slips.sort_by_key(|(_, slip)| slip.place);
    let arithmetic = Listed {
        tag: ARITHMETIC,
        laws: Vec::new(),
        did: "worked out something wrongly after right equations",
        sentence: "What you need is there: look for an error in the arithmetic after it.",
    };
    let listed =
        |(laws, slip): (Vec<Law>, &Slip)| Listed { tag: slip.tag, laws, did: slip.did, sentence: slip.sentence };
    let last = last_step::ALL.iter().map(|step| Listed {
        tag: step.tag,
        laws: Vec::new(),
        did: step.did,
        sentence: step.sentence,
    });
    slips.into_iter().map(listed).chain(last).chain([arithmetic]).collect()
}
