//! No more model than a scene needs: the cheapest geometry and the cheapest numbers that suffice, and why.
//!
//! Each tier says which needs it cannot meet; the first that can meet all of a scene's is taken. What the lists claim
//! is proved without a clock in `tests/methods/`: the choice finds what the highest tier finds; each cheaper tier refuses the
//! scene or is wrong on a recorded one; to cross out a need anywhere breaks the first of these; and to add a need to a scene
//! never lowers its tier.

use super::answer::{fractions, integers, letters, linear_forms, polynomials, surd_field, surd_integers};
use super::{Found, Geometry, Impact, Method, Need, Needs, Prepared, Skip, Wanted, method};
use crate::number::{Decimal, Places, Value, round_certified};

impl Geometry {
    /// The needs that it cannot meet.
    pub fn lacks(self) -> &'static [Need] {
        match self {
            Geometry::AtRest => &[Need::MovingB, Need::Across, Need::Oblique],
            Geometry::HeadOn => &[Need::Across, Need::Oblique],
            Geometry::Axis => &[Need::Oblique],
            Geometry::AnyLine => &[],
        }
    }

    /// The first that meets the needs.
    pub fn least(needs: Needs) -> Geometry {
        first(&Geometry::ALL, Geometry::lacks, needs).unwrap_or(Geometry::AnyLine)
    }
}

/// A tier of numbers, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Numbers {
    /// Machine integers over one denominator.
    Integers,
    /// Doubles with a proved bound.
    CertifiedFloat,
    /// Machine integers for each of 1, √2, √3, √6.
    SurdIntegers,
    /// Machine integers for each of cos α and sin α, or of four other things.
    LinearForms,
    /// The field of √2 and √3 in machine integers.
    SurdField,
    /// Short polynomials in letters, in machine integers.
    Polynomials,
    /// Fractions of any size.
    Fractions,
    /// Exact values of every kind.
    Letters,
}

impl Numbers {
    /// Every tier, the cheapest first.
    pub const ALL: [Numbers; 8] = [
        Numbers::Integers,
        Numbers::CertifiedFloat,
        Numbers::SurdIntegers,
        Numbers::LinearForms,
        Numbers::SurdField,
        Numbers::Polynomials,
        Numbers::Fractions,
        Numbers::Letters,
    ];

    /// The needs that it cannot meet.
    pub fn lacks(self) -> &'static [Need] {
        match self {
            Numbers::Integers => &[Need::Irrational, Need::Factors, Need::Large],
            Numbers::CertifiedFloat => &[Need::ExactForm, Need::Letters],
            Numbers::SurdIntegers => &[Need::OtherThings, Need::Factors, Need::Large],
            Numbers::LinearForms => &[Need::ManyThings, Need::Factors, Need::Large],
            Numbers::SurdField => &[Need::OutsideField, Need::Large],
            Numbers::Polynomials => &[Need::BeyondPolynomials],
            Numbers::Fractions => &[Need::Irrational, Need::Factors],
            Numbers::Letters => &[],
        }
    }

    /// The first that meets the needs.
    pub fn least(needs: Needs) -> Numbers {
        first(&Numbers::ALL, Numbers::lacks, needs).unwrap_or(Numbers::Letters)
    }

    /// The name of its method: `surd-integers`.
    pub fn name(self) -> &'static str {
        match self {
            Numbers::Integers => "integers",
            Numbers::CertifiedFloat => "certified-float",
            Numbers::SurdIntegers => "surd-integers",
            Numbers::LinearForms => "linear-forms",
            Numbers::SurdField => "surd-field",
            Numbers::Polynomials => "polynomials",
            Numbers::Fractions => "fractions",
            Numbers::Letters => "letters",
        }
    }

    /// Its method.
    pub fn method(self) -> &'static dyn Method {
        method(self.name()).expect("the list of methods has every tier")
    }

    /// Impacts ready to be solved by a geometry, whether or not it suffices.
    ///
    /// # Errors
    ///
    /// As for [`Method::prepare`].
    pub fn prepare(self, impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
        match self {
            Numbers::Integers => integers::prepare(impacts, geometry),
            // Its geometry is worked out exactly beforehand.
            Numbers::CertifiedFloat => self.method().prepare(impacts),
            Numbers::SurdIntegers => surd_integers::prepare(impacts, geometry),
            Numbers::LinearForms => linear_forms::prepare(impacts, geometry),
            Numbers::SurdField => surd_field::prepare(impacts, geometry),
            Numbers::Polynomials => polynomials::prepare(impacts, geometry),
            Numbers::Fractions => fractions::prepare(impacts, geometry),
            Numbers::Letters => letters::prepare(impacts, geometry),
        }
    }

    /// Why it suffices, as a sentence without a full stop.
    fn suffices(self) -> &'static str {
        match self {
            Numbers::Integers => "all components, e, the ratio of the masses and the line of centres are rational",
            Numbers::CertifiedFloat => "figures are asked for, and the error of a float has a proved bound",
            Numbers::SurdIntegers => {
                "all components are a + b√2 + c√3 + d√6, and e and the ratio of the masses rational"
            }
            Numbers::LinearForms => {
                "all components are sums of at most four things, such as cos α and sin α, and e and the ratio of the masses rational"
            }
            Numbers::SurdField => "all numbers are a + b√2 + c√3 + d√6",
            Numbers::Polynomials => {
                "masses, e and the line of centres are short polynomials in letters, and the components too but for roots"
            }
            Numbers::Fractions => "all numbers are rational, of any size",
            Numbers::Letters => "everything can be written in letters and roots",
        }
    }
}

/// The first tier that lacks none of the needs.
fn first<T: Copy>(tiers: &[T], lacks: impl Fn(T) -> &'static [Need], needs: Needs) -> Option<T> {
    tiers.iter().copied().find(|tier| !lacks(*tier).iter().any(|need| needs.has(*need)))
}

/// What was chosen for a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Selection {
    /// How much geometry.
    pub geometry: Geometry,
    /// Which numbers.
    pub numbers: Numbers,
    /// What the scene needs; of polynomials only where no cheaper tier suffices.
    pub needs: Needs,
}

impl Selection {
    /// The least that suffices.
    pub fn of(impact: &Impact<Value>, wanted: Wanted) -> Selection {
        let mut needs = Needs::but_for_polynomials(impact, wanted);
        if Numbers::least(needs) >= Numbers::Polynomials {
            needs = Needs::of(impact, wanted);
        }
        Selection { geometry: Geometry::least(needs), numbers: Numbers::least(needs), needs }
    }

    /// Why: what suffices, and what a cheaper tier would have lacked.
    pub fn why(&self) -> String {
        let cheaper = Numbers::ALL.into_iter().rev().skip_while(|tier| *tier >= self.numbers);
        let exact = |tier: &Numbers| !tier.lacks().contains(&Need::ExactForm);
        let missing = cheaper.filter(exact).find_map(|tier| {
            let need = tier.lacks().iter().find(|need| self.needs.has(**need))?;
            Some(format!("; {} would not do, since {}", tier.name(), need.words()))
        });
        format!("{}{}", self.numbers.suffices(), missing.unwrap_or_default())
    }

    /// The impact solved by what was chosen.
    pub fn solve(&self, impact: &Impact<Value>) -> Found {
        match self.numbers.prepare(std::slice::from_ref(impact), self.geometry) {
            Ok(mut prepared) => {
                prepared.run();
                prepared.found().swap_remove(0)
            }
            Err(skip) => Found::Missed(skip.why),
        }
    }
}

/// All four components rounded, each figure proved: by a certified float where its bound allows, else exactly; and the
/// tier that was needed. `None` where no method has a number for a component, as for letters.
///
/// ```
/// use carom::method::{Impact, Numbers, figures};
/// use carom::number::{Places, Value};
/// let [nought, one, two, root] = [Value::from(0), Value::from(1), Value::from(2), Value::from(2).square_root().unwrap()];
/// let impact = Impact {
///     masses: [one.clone(), two],
///     before: [[root, nought.clone()], [nought.clone(), nought.clone()]],
///     line: [one.clone(), nought],
///     restitution: one,
/// };
/// let (after, tier) = figures(&impact, &Places::SignificantFigures(3)).unwrap();
/// // Nothing was across, and the float says so exactly.
/// assert_eq!((after[0][0].to_string().as_str(), tier), ("-0.471", Numbers::CertifiedFloat));
/// ```
pub fn figures(impact: &Impact<Value>, places: &Places) -> Option<([[Decimal; 2]; 2], Numbers)> {
    let mut needs = Needs::of(impact, Wanted::Figures);
    loop {
        let numbers = Numbers::least(needs);
        let found = Selection { geometry: Geometry::least(needs), numbers, needs }.solve(impact);
        let rounded = match &found {
            Found::Exact(after) => {
                let flat = after.as_flattened().iter().map(|value| value.rounded(places).ok());
                flat.collect::<Option<Vec<Decimal>>>()
            }
            Found::Enclosed(after) => {
                // An enclosure that does not settle the figures is refused, and asked no second time.
                let one = |value| round_certified(|_| Some(Clone::clone(value)), |_| false, places).ok();
                after.as_flattened().iter().map(one).collect()
            }
            _ => None,
        };
        match rounded.map(<[Decimal; 4]>::try_from) {
            Some(Ok([a_x, a_y, b_x, b_y])) => return Some(([[a_x, a_y], [b_x, b_y]], numbers)),
            _ if needs.has(Need::ExactForm) => return None,
            _ => needs = needs.with(Need::ExactForm),
        }
    }
}
