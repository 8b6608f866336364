//! The notes that a verdict can carry: fixed tags, free of a question's numbers, each with a teacher's sentence.

use super::Verdict;

/// Declares the notes once: name, tag, sentence.
macro_rules! notes {
    ($($(#[$doc:meta])* $name:ident, $tag:literal, $sentence:literal;)*) => {
        /// Why an answer fares as it does.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Note { $($(#[$doc])* $name,)* }

        impl Note {
            /// Every note, in the order in which the documentation lists them.
            pub const ALL: &'static [Note] = &[$(Note::$name,)*];

            /// The tag, which reports and other programs rely on.
            pub fn tag(self) -> &'static str {
                match self { $(Note::$name => $tag,)* }
            }

            /// What a teacher would say.
            pub fn sentence(self) -> &'static str {
                match self { $(Note::$name => $sentence,)* }
            }
        }
    };
}

notes! {
    /// Rounded to fewer figures than asked.
    UnderAccurate, "under-accurate", "Right as far as it goes: give more figures.";
    /// Cut off where it should have been rounded.
    Truncated, "truncated", "Round the last figure instead of cutting the number off.";
    /// Close, and not right.
    NearMiss, "near-miss", "Very close: keep full accuracy until the last line.";
    /// Right for a value that was rounded on the way.
    EarlyRounding, "early-rounding", "Right but for a value that was rounded on the way: keep all the figures until the last line.";
    /// One significant figure, which is no evidence of anything.
    TooFewFigures, "too-few-figures", "One significant figure is not enough to go by.";
    /// A decimal where the exact value is wanted.
    ExactWanted, "exact-wanted", "Right as a decimal, but the exact value is wanted.";
    /// Rounds as it should, and its further figures are not right.
    LaterFigures, "later-figures", "It rounds to the right figures, though those further on are not right.";
    /// Right, and something was written after it that is not.
    IgnoredAfter, "ignored-after", "The right answer was reached; what follows it is ignored.";
    /// The opposite sign.
    Sign, "sign", "The size is right and the sign is not.";
    /// A change of the opposite sign to a loss, and named as one.
    ChangeNotLoss, "change-not-loss", "As a change it is negative, so the loss is right.";
    /// A letter that the whole answer is a multiple of is missing.
    LetterMissing, "letter-missing", "Right but for a letter: the answer is a multiple of it.";
    /// The same, and the sign is not right either.
    LetterAndSign, "letter-and-sign", "A letter is missing, and the sign is not right either.";
    /// Powers of the letters for masses and speeds are missing, or too many.
    PowersOfLetters, "powers-of-letters", "Right but for powers of its letters: an impulse has a mass and a speed in it, an energy a mass and the square of a speed.";
    /// A letter that the question does not have.
    UnknownLetter, "unknown-letter", "The answer has a letter that the question does not have.";
    /// A unit that is often written for the right one.
    UnitCondoned, "unit-condoned", "The value is right; the unit is N s, newtons times seconds.";
    /// A unit of something else.
    UnitWrong, "unit-wrong", "The value is right and the unit is not.";
    /// A unit on a pure number.
    UnitNotNeeded, "unit-not-needed", "The value is right, but it is a pure number and has no unit.";
    /// A multiple of the unit, converted.
    UnitConverted, "unit-converted", "Right once converted to the usual unit.";
    /// The complement without the line from which it would be right.
    Complement, "complement", "That is 90° minus the angle asked for: check the line from which it is measured.";
    /// The supplement.
    Supplement, "supplement", "That is 180° minus the angle asked for: check which way the sphere moves.";
    /// The number is that from another line.
    ReferenceWrong, "reference-wrong", "The number is right, but not measured from the line that you name.";
    /// Nobody but a person can tell how that line lies.
    ReferenceUnchecked, "reference-unchecked", "Measured from a line that the question does not speak of.";
    /// Radians without saying so.
    RadiansUnstated, "radians-unstated", "That is the angle in radians, which must be said.";
    /// The tangent, sine or cosine of the angle instead of the angle.
    RatioOfAngle, "angle-not-evaluated", "Right so far: find the angle itself.";
    /// The angle where its tangent is asked.
    AngleForTangent, "angle-for-tangent", "That is the angle; its tangent is asked for.";
    /// A velocity without its direction.
    DirectionMissing, "direction-missing", "The size is right; a velocity needs its direction too.";
    /// A velocity with the direction of something else.
    DirectionWrong, "direction-wrong", "The size is right and the direction is not.";
    /// The model answer has no direction.
    DirectionUnchecked, "direction-unchecked", "The size is right; the direction is for a person to check.";
    /// An end of a range counted in or out where it is not.
    RangeEnd, "range-end", "The ends are right: look whether each of them belongs to the range.";
    /// One end of a range that has two.
    RangeHalf, "range-half", "Right as far as it goes: the range has another end.";
    /// An inequality in which the letter does not stand by itself.
    RangeUnsolved, "range-unsolved", "Right so far: solve the inequality for the letter itself.";
    /// An end where the letter cannot be.
    RangeTooFar, "range-too-far", "The letter cannot be so much: give the range with the end that it has.";
    /// An inequality the wrong way round.
    RangeTurned, "range-turned", "The number is right and the inequality is the wrong way round.";
    /// An end of a range in place of the range.
    RangeWanted, "range-wanted", "That is where the range ends: say on which side of it the values lie.";
    /// Another number where a range is asked for.
    NotARange, "not-a-range", "A range is asked for: write it with an inequality sign.";
    /// Coordinates of a point in place of a vector.
    Coordinates, "coordinates", "Right, but a vector is written with i and j or as a column.";
    /// A number where a vector is asked.
    ScalarForVector, "scalar-for-vector", "A vector is asked for: give both components.";
    /// A number added to a vector.
    NumberPlusVector, "number-plus-vector", "A number cannot be added to a vector: an i or j is missing.";
    /// A vector where its magnitude is asked.
    VectorForScalar, "magnitude-not-evaluated", "Right so far: find the magnitude of this vector.";
    /// The square of what is asked.
    SquareLeft, "square-not-rooted", "Right so far: this is the square; take its root.";
    /// A true equation in powers, roots or functions of what is asked.
    Unsolved, "not-solved", "Right so far: solve this equation for what is asked.";
    /// The components of a velocity, one by one.
    ComponentsLeft, "components-not-combined", "Right so far: put the components together to a size and a direction.";
    /// The components in the wrong order.
    ComponentsExchanged, "components-exchanged", "The two components are exchanged.";
    /// The reciprocal.
    Inverted, "inverted", "Upside down: this is one over the answer.";
    /// A ratio where a number is asked.
    RatioForNumber, "ratio-for-number", "Right as a ratio; a single number is asked for.";
    /// A ratio that names its spheres the other way about.
    RatioUnchecked, "ratio-unchecked", "Which sphere comes first is for a person to check.";
    /// The value without the equation.
    NotAnEquation, "not-an-equation", "An equation is asked for: write both sides.";
    /// A gradient that is not called one.
    GradientUnstated, "gradient-unstated", "A direction is asked for: say that this is a gradient.";
    /// The printed result written once more.
    Restated, "restated", "This is the result to be shown; the marks are for the working.";
    /// An equation that comes to the printed result and is not it.
    NotAsPrinted, "not-as-printed", "It comes to the same, but must end exactly as printed, with its working.";
    /// Working, which a final line alone cannot earn.
    WorkingUnjudged, "working-not-judged", "A step towards the result; the marks are for the whole working.";
    /// Two answers that exclude each other.
    RivalAnswers, "rival-answers", "Two different answers are offered: choose one.";
    /// Right, under the name of another sphere or another quantity.
    NamedOtherwise, "named-otherwise", "The value is right, but is called by another name: a person should look at it.";
    /// Several values, and it is not clear which of them is meant.
    SeveralAnswers, "several-answers", "One of these is right: say which is the answer.";
    /// Nothing.
    Blank, "blank", "No answer.";
    /// It cannot be read.
    CannotBeRead, "cannot-be-read", "This cannot be read: a person should look at it.";
    /// Longer than what is read.
    TooLong, "too-long", "Longer than the 2000 characters that are read of an answer: a person should look at it.";
    /// The numerator of the answer, as if the line had ended there.
    BrokenOff, "broken-off", "This is the top line of the answer: a person should see whether the rest is missing.";
    /// It can be read and not compared.
    CannotBeCompared, "cannot-be-compared", "This can be read but not compared: a person should look at it.";
}

/// What is said of an answer with no note.
pub(super) fn plain_sentence(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Correct => "Right.",
        Verdict::Partial => "Partly right.",
        Verdict::Wrong => "Not the answer.",
        Verdict::Unreadable => Note::CannotBeRead.sentence(),
        Verdict::Blank => Note::Blank.sentence(),
    }
}
