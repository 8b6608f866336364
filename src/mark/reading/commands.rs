//! LaTeX commands that stand for a sign or a word.

use super::characters::Glyph;

/// Has it two arguments, one above the other?
pub(super) fn is_fraction(command: &str) -> bool {
    matches!(command, "frac" | "dfrac" | "tfrac" | "cfrac" | "nicefrac" | "sfrac")
}

/// The letters with which the glyphs begin.
pub(super) fn spelt(glyphs: &[Glyph]) -> String {
    glyphs.iter().map(|glyph| glyph.sign).take_while(char::is_ascii_alphabetic).collect()
}

/// The name of a fraction whose stroke is lost: `frac{25}{7}`.
pub(super) fn bare_fraction(glyphs: &[Glyph], at: usize) -> Option<String> {
    let begins = matches!(glyphs[at].sign, 'f' | 'd' | 't' | 'c')
        && !at.checked_sub(1).is_some_and(|before| glyphs[before].sign.is_ascii_alphabetic());
    let name = begins.then(|| spelt(&glyphs[at..])).filter(|name| is_fraction(name))?;
    glyphs.get(at + name.len()).filter(|next| next.sign == '{').map(|_| name)
}

/// Is it a sign, a root or a fraction?
pub(super) fn is_mathematics(command: &str) -> bool {
    is_fraction(command) || command == "sqrt" || simple(command).is_some()
}

/// Commands that stand for signs or words. Blanks keep words apart from what follows.
pub(super) fn simple(command: &str) -> Option<&'static str> {
    Some(match command {
        // A converter may write so the point of a decimal: it is read as the sign that it stands for.
        "cdot" => "⋅",
        "times" | "ast" => " * ",
        "div" => "÷",
        "colon" | "ratio" => ":",
        "land" | "wedge" => " and ",
        "pm" => "±",
        "propto" => " proportional to ",
        "degree" | "circ" | "textdegree" => "°",
        "le" | "leq" | "leqslant" => "≤",
        "ge" | "geq" | "geqslant" => "≥",
        "lt" => "<",
        "gt" => ">",
        "ne" | "neq" => "≠",
        "top" | "intercal" => "T",
        "surd" => "√",
        "in" => "∈",
        "infty" => "∞",
        "approx" | "simeq" | "cong" => "≈",
        "Rightarrow" | "implies" | "therefore" | "to" | "rightarrow" | "Longrightarrow" => "⇒",
        "because" => " because ",
        "perp" => " perpendicular ",
        "parallel" => " parallel to ",
        "angle" => " angle ",
        "quad" | "qquad" | "hspace" | "thinspace" | "newline" => " ",
        "displaystyle" | "textstyle" | "limits" | "big" | "Big" | "bigl" | "bigr" | "Bigl" | "Bigr" | "bigg"
        | "Bigg" | "biggl" | "biggr" => "",
        "lvert" | "rvert" | "vert" | "mid" => "|",
        "langle" => "(",
        "rangle" => ")",
        "dots" | "ldots" | "cdots" => "…",
        "imath" => "i",
        "jmath" => "j",
        "percent" => "%",
        // siunitx
        "metre" | "meter" | "m" => " m ",
        "second" | "s" => " s ",
        "kilogram" | "kg" => " kg ",
        "newton" | "N" => " N ",
        "joule" | "J" => " J ",
        "radian" => " rad ",
        "per" => "/",
        "squared" => "^2",
        "equiv" => "=",
        "doteq" => "≈",
        "lVert" | "rVert" | "Vert" => "|",
        "sin" => " sin ",
        "cot" => " cot ",
        "sec" => " sec ",
        "csc" | "cosec" => " csc ",
        "arccot" => " arccot ",
        "arcsec" => " arcsec ",
        "arccsc" | "arccosec" => " arccsc ",
        "cos" => " cos ",
        "tan" => " tan ",
        "arcsin" => " arcsin ",
        "arccos" => " arccos ",
        "arctan" => " arctan ",
        "pi" => "π",
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "delta" => "δ",
        "epsilon" | "varepsilon" => "ε",
        "zeta" => "ζ",
        "eta" => "η",
        "theta" | "vartheta" => "θ",
        "iota" => "ι",
        "kappa" => "κ",
        "lambda" => "λ",
        "mu" => "μ",
        "nu" => "ν",
        "xi" => "ξ",
        "rho" => "ρ",
        "sigma" => "σ",
        "tau" => "τ",
        "upsilon" => "υ",
        "phi" | "varphi" => "φ",
        "chi" => "χ",
        "psi" => "ψ",
        "omega" => "ω",
        "Gamma" => "Γ",
        "Delta" => "Δ",
        "Theta" => "Θ",
        "Lambda" => "Λ",
        "Xi" => "Ξ",
        "Pi" => "Π",
        "Sigma" => "Σ",
        "Phi" => "Φ",
        "Psi" => "Ψ",
        "Omega" => "Ω",
        _ => return None,
    })
}
