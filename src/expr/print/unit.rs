//! Units in each printed form, with the thin space that parts them from their number.

use crate::unit::Unit;

/// What follows a number in LaTeX's mathematics: `\,\mathrm{m\,s^{-1}}`, `^\circ`, or nothing.
pub fn unit_latex(unit: Unit) -> &'static str {
    match unit {
        Unit::None => "",
        Unit::Kilogram => r"\,\mathrm{kg}",
        Unit::Metre => r"\,\mathrm{m}",
        Unit::MetrePerSecond => r"\,\mathrm{m\,s^{-1}}",
        Unit::NewtonSecond => r"\,\mathrm{N\,s}",
        Unit::Joule => r"\,\mathrm{J}",
        Unit::Degree => r"^\circ",
    }
}

/// What follows a number in MathML.
pub fn unit_mathml(unit: Unit) -> &'static str {
    match unit {
        Unit::None => "",
        Unit::Kilogram => r#"<mspace width="0.1667em"/><mi mathvariant="normal">kg</mi>"#,
        Unit::Metre => r#"<mspace width="0.1667em"/><mi mathvariant="normal">m</mi>"#,
        Unit::MetrePerSecond => concat!(
            r#"<mspace width="0.1667em"/><mi mathvariant="normal">m</mi>"#,
            r#"<mspace width="0.1667em"/><msup><mi mathvariant="normal">s</mi>"#,
            r#"<mrow><mo form="prefix">−</mo><mn>1</mn></mrow></msup>"#
        ),
        Unit::NewtonSecond => concat!(
            r#"<mspace width="0.1667em"/><mi mathvariant="normal">N</mi>"#,
            r#"<mspace width="0.1667em"/><mi mathvariant="normal">s</mi>"#
        ),
        Unit::Joule => r#"<mspace width="0.1667em"/><mi mathvariant="normal">J</mi>"#,
        Unit::Degree => r#"<mi mathvariant="normal">°</mi>"#,
    }
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
