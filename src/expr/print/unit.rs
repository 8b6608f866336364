//! Units in each printed form, with the thin space that parts them from their number.

use crate::unit::Unit;

/// A symbol and the power to which it stands.
fn symbols(unit: Unit) -> &'static [(&'static str, i32)] {
    match unit {
        Unit::None | Unit::Degree => &[],
        Unit::Kilogram => &[("kg", 1)],
        Unit::Metre => &[("m", 1)],
        Unit::MetrePerSecond => &[("m", 1), ("s", -1)],
        Unit::NewtonSecond => &[("N", 1), ("s", 1)],
        Unit::Joule => &[("J", 1)],
    }
}

/// What follows a number in LaTeX's mathematics: `\,\mathrm{m\,s^{-1}}`, `^\circ`, or nothing.
pub fn unit_latex(unit: Unit) -> String {
    let power = |&(symbol, power): &(&str, i32)| match power {
        1 => symbol.to_owned(),
        _ => format!("{symbol}^{{{power}}}"),
    };
    let parts: Vec<String> = symbols(unit).iter().map(power).collect();
    match unit {
        Unit::None => String::new(),
        Unit::Degree => r"^\circ".to_owned(),
        _ => format!(r"\,\mathrm{{{}}}", parts.join(r"\,")),
    }
}

/// What follows a number in MathML.
pub fn unit_mathml(unit: Unit) -> String {
    if unit == Unit::Degree {
        return r#"<mi mathvariant="normal">°</mi>"#.to_owned();
    }
    let mut out = String::new();
    for (symbol, power) in symbols(unit) {
        out.push_str(r#"<mspace width="0.1667em"/>"#);
        let letters = format!(r#"<mi mathvariant="normal">{symbol}</mi>"#);
        match power {
            1 => out.push_str(&letters),
            _ => out.push_str(&format!(
                r#"<msup>{letters}<mrow><mo form="prefix">−</mo><mn>{}</mn></mrow></msup>"#,
                power.unsigned_abs()
            )),
        }
    }
    out
}

/// What follows a number on a terminal: ` m s⁻¹`, `°`, or nothing.
pub fn unit_unicode(unit: Unit) -> &'static str {
    match unit {
        Unit::None => "",
        Unit::Kilogram => " kg",
        Unit::Metre => " m",
        Unit::MetrePerSecond => " m s⁻¹",
        Unit::NewtonSecond => " N s",
        Unit::Joule => " J",
        Unit::Degree => "°",
    }
}
