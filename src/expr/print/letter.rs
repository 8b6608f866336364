//! How a name is printed: Greek letters, subscripts, and words in upright type.

use std::borrow::Cow;

/// A name taken apart.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Letter<'e> {
    /// What stands on the line.
    pub base: Symbol<'e>,
    /// What stands below it.
    pub subscript: Option<Symbol<'e>>,
}

/// One part of a [`Letter`].
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Symbol<'e> {
    /// Latin letters and digits, in italics.
    Italic(Cow<'e, str>),
    /// The letter of a vector, bold and upright.
    Vector(char),
    /// A Greek letter by its name, as LaTeX and the language know it, and as a character.
    Greek(&'static str, char),
    /// A word, or a text that is no name of the language; printers escape it.
    Upright(Cow<'e, str>),
}

/// Names of Greek letters; those that look like Latin ones are left out, as LaTeX does.
static GREEK: [(&str, char); 33] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// What the name of a vector begins with, in formulas that carom composes. It is never read.
pub(super) const VECTOR: &str = "vector.";

/// The Greek letter of a name.
fn greek(name: &str) -> Option<Symbol<'static>> {
    // most names are a single letter, and none of those is in the list
    if name.len() < 2 {
        return None;
    }
    let (name, character) = GREEK.iter().find(|(known, _)| *known == name)?;
    Some(Symbol::Greek(name, *character))
}

/// A name taken apart: `v_A`, `u1`, `alpha`, `KE`; `vector.v_A` is the vector of that name.
pub(super) fn letter(name: &str) -> Letter<'_> {
    if let Some(vector) = name.strip_prefix(VECTOR) {
        let plain = letter(vector);
        let base = match plain.base {
            Symbol::Italic(text) if text.len() == 1 => text.chars().next().map_or(Symbol::Italic(text), Symbol::Vector),
            other => other,
        };
        return Letter { base, subscript: plain.subscript };
    }
    let in_language = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    if !in_language {
        return Letter { base: Symbol::Upright(name.into()), subscript: None };
    }
    let (base, below) = match name.split_once('_') {
        Some(parts) => parts,
        None => name.split_at(name.trim_end_matches(|c: char| c.is_ascii_digit()).len()),
    };
    let base = match greek(base) {
        Some(symbol) => symbol,
        None if base.len() == 1 => Symbol::Italic(base.into()),
        None => Symbol::Upright(base.into()),
    };
    let subscript = (!below.is_empty()).then(|| match greek(below) {
        Some(symbol) => symbol,
        None if below.contains('_') => Symbol::Italic(below.replace('_', ",").into()),
        None => Symbol::Italic(below.into()),
    });
    Letter { base, subscript }
}
