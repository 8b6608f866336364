//! A question whose file has been checked: everything read, every name known, nothing chosen yet.

use std::fmt;
use std::ops::Range;

use super::{Domain, EarnedFor, Requirement};
use crate::answer::{Accept, Kind};
use crate::expr::{Expr, Markup, Text};
use crate::mechanics::{Quantity, SceneText};

/// A question of a bank.
#[derive(Clone, Debug)]
pub struct Question {
    /// Its path in the bank without `.toml`: `rest/speeds-and-directions`.
    pub id: String,
    /// Its heading in lists.
    pub title: String,
    /// The exercise whose skills it practises: `5C-2`.
    pub mirrors: Option<String>,
    /// The topic under which it is listed.
    pub topic: String,
    /// The styles in which it can be set, in the order of its file; at least one.
    pub styles: Vec<Style>,
    /// The collision, in parameters, derived names and letters.
    pub scene: SceneText,
    /// What is asked; at least one part.
    pub parts: Vec<Part>,
    /// The numbers of the exercise that it mirrors, which may lie outside the domains.
    pub reference: Vec<(String, Expr)>,
    /// The style whose words the reference numbers fit, by its place in `styles`.
    pub reference_style: usize,
    /// What was wrong with the exercise that it mirrors.
    pub erratum: Option<String>,
    /// Tags of slips that its author knows to be hidden by some of its numbers.
    pub hidden: Vec<String>,
    /// Pairs of tags of slips that its author knows it cannot tell apart.
    pub alike: Vec<(String, String)>,
    /// Answers that its author has worked out.
    pub tests: Vec<AuthorsTest>,
}

/// Answers that the author of a question has worked out by hand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AuthorsTest {
    /// Where it stands in the file.
    pub span: Range<usize>,
    /// The style whose numbers they are, by its place in `styles`.
    pub style: usize,
    /// The numbers.
    pub numbers: Vec<(String, Expr)>,
    /// The names of what is asked, as `find` has them, and the answers as a student would write them.
    pub answers: Vec<(String, String)>,
}

impl Question {
    /// The style with a name.
    pub fn style(&self, name: StyleName) -> Option<&Style> {
        self.styles.iter().find(|style| style.name == name)
    }

    /// Every quantity that an answer asks for, each once, in order.
    pub fn asked(&self) -> Vec<Quantity> {
        let mut asked = Vec::new();
        for quantity in self.parts.iter().flat_map(Part::asked) {
            if !asked.contains(&quantity) {
                asked.push(quantity);
            }
        }
        asked
    }

    /// Is a name given in a style: a parameter, a derived name, or a letter of the scene?
    pub fn is_given(&self, style: &Style, name: &str) -> bool {
        let derived = || style.lets.iter().any(|(own, _)| own == name);
        let letter = || self.scene.symbols.iter().any(|(own, _)| own == name);
        style.parameters.iter().any(|(own, _)| own == name) || derived() || letter()
    }

    /// What must be solved for in a style: all that is asked, and what its requirements name.
    pub fn wanted(&self, style: &Style) -> Vec<Quantity> {
        let mut wanted = self.asked();
        for requirement in &style.require {
            for quantity in requirement.quantities(&|name| self.is_given(style, name)) {
                if !wanted.contains(&quantity) {
                    wanted.push(quantity);
                }
            }
        }
        wanted
    }

    /// Marks of all parts together.
    pub fn marks(&self) -> usize {
        self.parts.iter().map(|part| part.marks.len()).sum()
    }
}

/// The manner of a question's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StyleName {
    /// Whole numbers and Pythagorean angles.
    Friendly,
    /// Surds.
    Exact,
    /// Any degree; answers are rounded.
    Calculator,
}

impl StyleName {
    /// Every style, in the order in which messages list them.
    pub const ALL: [StyleName; 3] = [StyleName::Friendly, StyleName::Exact, StyleName::Calculator];

    /// Its name in a bank file and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            StyleName::Friendly => "friendly",
            StyleName::Exact => "exact",
            StyleName::Calculator => "calculator",
        }
    }
}

impl fmt::Display for StyleName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A style with all that holds in it, the question's own included.
#[derive(Clone, Debug)]
pub struct Style {
    /// Its name.
    pub name: StyleName,
    /// The paragraphs before the first part.
    pub stem: Markup,
    /// A line after the stem, on the form of the answers; may be empty.
    pub note: Text,
    /// The parameters with their values, in the order of the file.
    pub parameters: Vec<(String, Domain)>,
    /// Names derived from them, each from those before it.
    pub lets: Vec<(String, Expr)>,
    /// What must hold.
    pub require: Vec<Requirement>,
}

impl Style {
    /// How many sets of parameters there are, whether they meet the requirements or not.
    pub fn size(&self) -> u64 {
        // The check of the file has refused products that do not fit.
        self.parameters.iter().fold(1, |size, (_, domain)| size.saturating_mul(domain.size()))
    }

    /// The set of parameters with an index below [`Style::size`]; the last parameter varies fastest.
    pub fn parameters_at(&self, index: u64) -> Vec<(String, Expr)> {
        self.parameters.iter().map(|(name, _)| name.clone()).zip(self.values_at(index)).collect()
    }

    /// The same without the names.
    pub fn values_at(&self, index: u64) -> Vec<Expr> {
        let mut rest = index;
        let mut chosen: Vec<Expr> = Vec::with_capacity(self.parameters.len());
        for (_, domain) in self.parameters.iter().rev() {
            chosen.push(domain.value(rest % domain.size()));
            rest /= domain.size();
        }
        chosen.reverse();
        chosen
    }
}

/// A part of a question.
#[derive(Clone, Debug)]
pub struct Part {
    /// `a`, `b`, …; empty if it is the only one.
    pub label: String,
    /// What is asked.
    pub ask: Markup,
    /// What is to be found, in the order asked; at least one.
    pub answers: Vec<Answer>,
    /// The marks in the order in which they are earned; at least one.
    pub marks: Vec<Mark>,
}

impl Part {
    /// The quantities for which it asks, in order.
    pub fn asked(&self) -> Vec<Quantity> {
        self.answers.iter().flat_map(|answer| answer.find.quantities()).collect()
    }
}

/// What is to be found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Find {
    /// A quantity of the collision.
    Quantity(Quantity),
    /// A vector by its two components.
    Vector(Quantity, Quantity),
    /// A letter that the scene names among its unknowns.
    Unknown(String),
}

impl Find {
    /// Its name in a bank file: the quantity, of a vector that of its first component, or the letter.
    pub fn name(&self) -> String {
        match self {
            Find::Quantity(quantity) | Find::Vector(quantity, _) => quantity.to_string(),
            Find::Unknown(name) => name.clone(),
        }
    }

    /// The quantities that must be known.
    pub fn quantities(&self) -> Vec<Quantity> {
        match self {
            Find::Quantity(quantity) => vec![*quantity],
            Find::Vector(x, y) => vec![*x, *y],
            Find::Unknown(_) => Vec::new(),
        }
    }

    /// Must the quantity be known?
    pub fn asks_for(&self, quantity: Quantity) -> bool {
        match self {
            Find::Quantity(own) => *own == quantity,
            Find::Vector(x, y) => *x == quantity || *y == quantity,
            Find::Unknown(_) => false,
        }
    }
}

/// An answer of a part.
#[derive(Clone, Debug)]
pub struct Answer {
    /// What it is, in words: `speed of A`.
    pub name: Text,
    /// What is to be found.
    pub find: Find,
    /// Its kind.
    pub kind: Kind,
    /// The rule by which a student's answer is accepted, where no style wants the exact value.
    pub(super) accept: Accept,
    /// The styles in which only the exact value is accepted, whatever the rule.
    pub(super) exact_in: Vec<StyleName>,
    /// Words that complete a direction; may be empty.
    pub phrase: Text,
    /// The left side of what is to be shown.
    pub show: Option<Expr>,
}

impl Answer {
    /// The rule by which a student's answer is accepted in a style.
    pub fn accept(&self, style: StyleName) -> &Accept {
        if self.exact_in.contains(&style) { &Accept::Exact } else { &self.accept }
    }

    /// Must the answer be exact only because the style says so?
    pub fn is_exact_by_style(&self, style: StyleName) -> bool {
        self.accept != Accept::Exact && self.exact_in.contains(&style)
    }
}

/// What a mark is awarded for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Code {
    /// `B1`: stands alone.
    B1,
    /// `M1`: method.
    M1,
    /// `A1`: accuracy, not without its method mark.
    A1,
    /// `dM1`: method, not without earlier ones.
    DependentM1,
    /// `A1ft`: accuracy, following through from the student's own earlier value.
    A1FollowThrough,
    /// `A1*`: a printed result, shown.
    A1Shown,
    /// `E1`: an explanation.
    E1,
}

impl Code {
    /// Every code, in the order in which messages list them.
    pub const ALL: [Code; 7] =
        [Code::B1, Code::M1, Code::A1, Code::DependentM1, Code::A1FollowThrough, Code::A1Shown, Code::E1];

    /// As it is printed: `dM1`.
    pub fn name(self) -> &'static str {
        match self {
            Code::B1 => "B1",
            Code::M1 => "M1",
            Code::A1 => "A1",
            Code::DependentM1 => "dM1",
            Code::A1FollowThrough => "A1ft",
            Code::A1Shown => "A1*",
            Code::E1 => "E1",
        }
    }

    /// What the marks' ids begin with: `M1` for `M1` and `dM1`, `A1` for every accuracy mark.
    pub(crate) fn stem(self) -> &'static str {
        match self {
            Code::B1 => "B1",
            Code::M1 | Code::DependentM1 => "M1",
            Code::A1 | Code::A1FollowThrough | Code::A1Shown => "A1",
            Code::E1 => "E1",
        }
    }

    /// Is it a mark for method?
    pub fn is_method(self) -> bool {
        matches!(self, Code::M1 | Code::DependentM1)
    }

    /// Is it a mark for accuracy?
    pub fn is_accuracy(self) -> bool {
        matches!(self, Code::A1 | Code::A1FollowThrough | Code::A1Shown)
    }
}

/// One mark of a part.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Its id within the part: `M1a`, the first `M1` or `dM1`.
    pub id: String,
    /// Its code.
    pub code: Code,
    /// The step that earns it.
    pub earned_for: EarnedFor,
    /// What earns it, if not in the usual words.
    pub text: Option<Text>,
    /// What the marker condones or demands, if not as usual.
    pub note: Option<Text>,
    /// Ids of the marks without which it is not given; all of them earlier in the part.
    pub depends: Vec<String>,
}
