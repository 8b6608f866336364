//! Velocities: a size and a direction.

use super::*;

#[test]
fn a_velocity_needs_its_size_and_its_direction() {
    let across = model("6*sin(10*deg) perpendicular to the line of centres", Some(Kind::Velocity), "");
    let oblique = model("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "");
    let size = model("6*sin(10*deg)", Some(Kind::Velocity), "");
    let towards = |text: &str, reference| Said { reference, ..value(text) };
    let angle = |text: &str, reference| Said { reference, unit: degrees(), ..value(text) };
    for (model, said, expected) in [
        (&across, vec![towards("1.04", Some(AlongCommonTangent))], "correct"),
        (&across, vec![towards("1.04", Some(AlongLineOfCentres))], "wrong direction-wrong"),
        (&across, vec![towards("1.04", None)], "partial direction-missing"),
        (&across, vec![towards("1.0", Some(AlongCommonTangent))], "partial under-accurate"),
        (&across, vec![towards("5.91", Some(AlongCommonTangent))], "wrong"),
        (&across, vec![towards("0", None)], "wrong"),
        (&across, vec![said(Form::AtRest)], "wrong"),
        (&across, vec![value("1.04"), angle("90", Some(LineOfCentres))], "correct"),
        (&oblique, vec![value("sqrt(13)"), angle("46.1", None)], "correct"),
        (&oblique, vec![value("3.61"), angle("46.1", Some(LineOfCentres))], "correct"),
        (&oblique, vec![value("3.61"), angle("43.9", Some(CommonTangent))], "correct"),
        (&oblique, vec![value("3.61"), angle("43.9", None)], "wrong complement"),
        (&oblique, vec![value("3.61"), value("46.1")], "correct"),
        (&oblique, vec![said(Form::Vector(expr("2.5"), expr("2.598"), Notation::Column))], "correct"),
        (&size, vec![towards("1.04", Some(AlongCommonTangent))], "partial direction-unchecked"),
        (&size, vec![towards("1.04", None)], "partial direction-missing"),
        (&size, vec![towards("1.4", None)], "wrong"),
    ] {
        let statements: Vec<_> = said.into_iter().map(|said| (None, said)).collect();
        assert_eq!(states(model, &statements), expected, "{statements:?}");
    }
}

#[test]
fn a_velocity_said_piece_by_piece_is_put_together() {
    const COMPONENTS: &str = "partial components-not-combined";
    fare(&[
        (
            "[5/2, 3*sqrt(3)/2]",
            Some(Kind::Velocity),
            "2.5 along the line of centres and 2.60 perpendicular to it",
            COMPONENTS,
        ),
        (
            "[5/2, 3*sqrt(3)/2]",
            Some(Kind::Velocity),
            "2.5 along LOC or 2.60 perpendicular to LOC",
            "wrong rival-answers",
        ),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3√3/2 perp, 5/2 along LOC", COMPONENTS),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "2.5 along and 2.60 perpendicular", COMPONENTS),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3 along LOC and 2 perpendicular to LOC", "wrong"),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3.61 m/s, tan θ = 3√3/5", "partial angle-not-evaluated"),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3.61 m/s, tan θ = 5/(3√3)", "wrong direction-wrong"),
        ("[5/2, 3*sqrt(3)/2]", Some(Kind::Velocity), "3.61 in direction 46.1° to the line of centres", "correct"),
    ]);
}
