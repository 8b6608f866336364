//! The ways in which a line departs from its law, what each costs and what a teacher would say.

/// A way in which a line departs from its law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(in crate::mark::working) enum Departure {
    Sign,
    SineForCosine,
    Inaccurate,
    LetterMissing,
    AnotherRestitution,
    NumberMisread,
    BracketsLost,
    Unresolved,
    TermMissing,
    MassesExchanged,
    MassesOmitted,
    MassMissing,
    VelocityElsewhere,
    RestitutionMissing,
    RestitutionOnWrongSide,
    Coalesced,
    WrongAxis,
    WeightsForMasses,
    InequalityReversed,
}

impl Departure {
    /// What a method mark condones.
    pub(in crate::mark::working) fn is_condoned(self) -> bool {
        use Departure::*;
        matches!(
            self,
            Sign | SineForCosine
                | Inaccurate
                | LetterMissing
                | AnotherRestitution
                | NumberMisread
                | BracketsLost
                | WeightsForMasses
        )
    }

    pub(in crate::mark::working) fn tag(self) -> &'static str {
        match self {
            Departure::Sign => "sign-error",
            Departure::SineForCosine => "sincos-swap",
            Departure::Inaccurate => "inaccurate",
            Departure::LetterMissing => "letter-missing",
            Departure::AnotherRestitution => "e-misread",
            Departure::NumberMisread => "number-misread",
            Departure::BracketsLost => "brackets-lost",
            Departure::Unresolved => "not-resolved",
            Departure::TermMissing => "term-missing",
            Departure::MassesExchanged => "masses-swapped",
            Departure::MassesOmitted => "masses-omitted",
            Departure::MassMissing => "mass-missing",
            Departure::VelocityElsewhere => "velocity-elsewhere",
            Departure::RestitutionMissing => "e-taken-as-1",
            Departure::RestitutionOnWrongSide => "e-wrong-side",
            Departure::Coalesced => "coalesce",
            Departure::WrongAxis => "wrong-axis",
            Departure::WeightsForMasses => "weights-for-masses",
            Departure::InequalityReversed => "inequality-reversed",
        }
    }

    /// What a teacher would say.
    pub(in crate::mark::working) fn sentence(self) -> &'static str {
        match self {
            Departure::Sign => "a sign is wrong: keep one positive direction for every term",
            Departure::SineForCosine => {
                "sine and cosine are exchanged: along the line of centres the component is u cos"
            }
            Departure::Inaccurate => "a number is not accurate enough",
            Departure::LetterMissing => "a letter of the question is left out of every term",
            Departure::AnotherRestitution => "e is not the one that is given",
            Departure::NumberMisread => "a number of the question is copied wrongly",
            Departure::BracketsLost => "a factor or a sign is not multiplied into all of its bracket",
            Departure::Unresolved => "a speed is not resolved along the line of centres",
            Departure::TermMissing => "a term is missing",
            Departure::MassesExchanged => "the masses are exchanged",
            Departure::MassesOmitted => "the masses are left out, and they do not cancel",
            Departure::MassMissing => "a mass is missing from one of the terms",
            Departure::VelocityElsewhere => "a velocity is that of another sphere, or of another moment",
            Departure::RestitutionMissing => "e is left out",
            Departure::RestitutionOnWrongSide => "e is on the wrong side: it multiplies the speed of approach",
            Departure::WrongAxis => "the components that change are those along the line of centres",
            Departure::WeightsForMasses => "weights are taken for the masses: there is no g in momentum",
            Departure::InequalityReversed => "the inequality points the wrong way",
            Departure::Coalesced => "the spheres separate after the impact; they do not move on together",
        }
    }

    /// How unlikely it is to be meant.
    pub(in crate::mark::working) fn weight(self) -> u32 {
        match self {
            Departure::Inaccurate | Departure::BracketsLost => 1,
            Departure::Sign | Departure::SineForCosine | Departure::WrongAxis => 2,
            Departure::AnotherRestitution | Departure::NumberMisread => 3,
            Departure::TermMissing | Departure::MassMissing => 5,
            _ => 4,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Departure::*;

    #[test]
    fn the_manual_lists_every_reason_with_its_tag_and_what_it_costs() {
        let page = include_str!("../../../../docs/marking.md");
        let all = [
            Sign,
            SineForCosine,
            Inaccurate,
            LetterMissing,
            AnotherRestitution,
            NumberMisread,
            BracketsLost,
            Unresolved,
            TermMissing,
            MassesExchanged,
            MassesOmitted,
            MassMissing,
            VelocityElsewhere,
            RestitutionMissing,
            RestitutionOnWrongSide,
            Coalesced,
            WrongAxis,
            WeightsForMasses,
            InequalityReversed,
        ];
        for departure in all {
            let costs = if departure.is_condoned() { "A" } else { "M and A" };
            let row = format!("| `{}` | {} | {costs} |", departure.tag(), departure.sentence());
            assert!(page.contains(&row), "docs/marking.md lacks\n{row}");
        }
    }
}
