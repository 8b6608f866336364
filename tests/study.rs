//! The study of methods: its claims in both directions, its promises, its charts and its command.
//!
//! `carom study` tries the same claims on more scenes.

use std::process::{Command, Output};
use std::sync::LazyLock;
use std::{env, fs};

use carom::diagnostic::Source;
use carom::method::{METHODS, Promise, Role};
use carom::render::RenderedFile;
use carom::study::{
    Arrangement, Bounds, CHAINS, Census, Dealer, Map, Outcome, QUANTITIES, REGIMES, ROUNDOFF, SMALL, Study, Subject,
    WHOLE, blocks, census, claims, methods, promised, read_times, regime_map, spread, try_all,
};

/// Enough to fail where something fails, and quick.
const SCENES: usize = 30;

static MAPS: LazyLock<(Vec<Map>, Vec<Map>)> = LazyLock::new(|| {
    let quantities = QUANTITIES.iter().map(|subject| subject.map(SCENES)).collect();
    (quantities, REGIMES.iter().map(|regime| regime_map(regime, SCENES)).collect())
});

static CENSUS: LazyLock<Census> = LazyLock::new(|| census(SMALL, &methods(), &mut || ()));

#[test]
fn carom_knows_up_to_where_each_arrangement_holds_and_from_where_it_fails() {
    let maps: Vec<Map> = MAPS.0.iter().chain(&MAPS.1).cloned().collect();
    let claims = claims().unwrap();
    assert!(claims.claim.len() > 40, "the table of claims was not found");
    let broken = try_all(&claims.claim, &maps);
    assert!(broken.is_empty(), "\n{}\n", broken.join("\n"));
}

#[test]
fn carom_counts_ghosts_and_ties_by_whole_numbers() {
    let found = &*CENSUS;
    // 148 of the 5,544 velocities are nought: counted once more, by fractions alone.
    assert_eq!((found.scenes, found.noughts, found.ties), (2772, 148, 212));
    let broken: Vec<String> = claims().unwrap().count.iter().filter_map(|claim| claim.tried(found)).collect();
    assert!(broken.is_empty(), "\n{}\n", broken.join("\n"));
    // An enclosure in doubles leaves open what lies on a tie or at nought, and nothing else.
    let certified = found.counts.iter().find(|count| count.method == "certified-float").unwrap();
    assert_eq!((certified.undecided, certified.undecided_plain), (found.noughts + found.ties, 0));
}

#[test]
fn every_method_keeps_its_promise_in_every_regime() {
    for regime in REGIMES {
        for method in METHODS.iter().filter(|method| method.role() != Role::Exhibit) {
            let bound = match method.promises() {
                Promise::Exact => 0.0,
                Promise::Scaled(roundoffs) => roundoffs * ROUNDOFF,
                Promise::Enclosed => f64::INFINITY,
                Promise::Nothing(_) => continue,
            };
            // A promise of floats is one for numbers that neither overflow nor lose figures by being tiny.
            if regime.name.ends_with("-units") && bound > 0.0 && bound.is_finite() {
                continue;
            }
            for k in regime.exponents.0..=regime.exponents.1 {
                let worst = promised(regime, k, *method, 4);
                // An enclosure may be as wide as the line, but must hold the truth: else there is no number.
                let kept = worst.within(bound) || (bound.is_infinite() && worst != Outcome::NoNumber);
                assert!(
                    kept || may_give_up(method.name(), regime.name),
                    "{} in {} at {k}: {worst:?}",
                    method.name(),
                    regime.name
                );
            }
        }
    }
}

/// Intervals of a fixed number of places cannot divide by what is below their last place, and say so.
fn may_give_up(method: &str, regime: &str) -> bool {
    method == "intervals" && regime == "small-units"
}

#[test]
fn a_map_of_few_scenes_is_never_worse_than_one_of_many() {
    for subject in QUANTITIES {
        let (few, many) = (subject.map(3), subject.map(9));
        for (few, many) in few.rows.iter().zip(&many.rows) {
            let pairs = few.worst.iter().zip(&many.worst);
            assert!(pairs.clone().all(|(few, many)| few.worse(*many) == *many), "{}: {few:?} {many:?}", subject.name);
        }
    }
}

#[test]
fn the_maps_can_tell_good_from_bad() {
    // Two arrangements of 1 - (1 - x) for small x: one subtracts, the other does not.
    let subject = Subject {
        name: "a-trial",
        quantity: "x",
        regime: "x = 10⁻ᵏ",
        exponents: (1, 15),
        arrangements: &[Arrangement { name: "twice", says: "1 - (1 - x)" }, Arrangement { name: "plain", says: "x" }],
        scene: |k, deal: &mut Dealer| {
            let x = deal.between(1.0, 9.0) * 10f64.powi(-(k as i32));
            let truth = carom::study::fraction(x).unwrap();
            vec![Outcome::relative(1.0 - (1.0 - x), &truth), Outcome::relative(x, &truth)]
        },
    };
    let map = subject.map(20);
    let fails = map.row("twice").unwrap().fails_from(map.first, 5e-4).unwrap();
    assert!((12..=14).contains(&fails), "{fails}");
    assert_eq!(map.row("plain").unwrap().fails_from(map.first, 0.0), None);
}

#[test]
fn the_grid_of_examinations_is_as_large_as_it_is_said_to_be() {
    assert_eq!(blocks(WHOLE) * 171, 310_365);
    assert_eq!(blocks(Bounds { mass: 1, parts: 1, speed: 1 }), 2);
}

/// The files of a study of a few scenes, with the times of the documentation.
static FILES: LazyLock<Vec<RenderedFile>> = LazyLock::new(|| {
    let (quantities, velocities) = MAPS.clone();
    let text = fs::read_to_string("docs/methods/times.csv").unwrap();
    let costs = read_times(&Source::new("docs/methods/times.csv", text)).unwrap();
    let spreads = CHAINS.iter().map(|chain| spread(chain, 3, 20)).collect();
    let (claims, census) = (claims().unwrap(), CENSUS.clone());
    Study { quantities, velocities, claims, broken: Vec::new(), census, spreads, costs }.files().unwrap()
});

#[test]
fn the_page_stands_by_itself_and_says_everything() {
    let files = &*FILES;
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "methods.html",
            "methods.md",
            "methods/errors.csv",
            "methods/grid.csv",
            "methods/tolerance.csv",
            "methods/times.csv",
            "methods/study.json",
            "methods/work-precision.svg",
            "methods/tiers.svg",
            "methods/stability-quantities.svg",
            "methods/stability-velocities.svg",
            "methods/tolerance.svg",
        ]
    );
    let page = &files[0].contents;
    assert!(!page.contains("<script") && !page.contains("src=") && !page.contains("href="), "no script, no network");
    assert_eq!(page.matches("<svg").count(), 5);
    for claim in claims().unwrap().claim {
        assert!(files[1].contents.contains(&claim.sentence), "{}", claim.sentence);
        let plain: Vec<&str> = claim.sentence.split('\'').collect();
        assert!(plain.iter().all(|piece| page.contains(piece)), "{}", claim.sentence);
    }
    for method in methods() {
        assert!(files[10].contents.contains(method.name()), "{} is not on the map", method.name());
    }
    let json: serde_json::Value = serde_json::from_str(&files[6].contents).unwrap();
    assert_eq!(json["exam_grid"]["noughts"], 148);
}

#[test]
fn the_chart_of_the_documentation_is_what_its_times_draw() {
    let files = &*FILES;
    for name in ["methods/work-precision.svg", "methods/tiers.svg", "methods/times.csv"] {
        let drawn = &files.iter().find(|file| file.name == name).unwrap().contents;
        let kept = fs::read_to_string(format!("docs/{name}")).unwrap();
        assert!(*drawn == kept, "docs/{name} is not fresh: see the head of docs/methods.md");
    }
}

fn carom(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).args(words).output().unwrap()
}

#[test]
fn what_is_wrong_with_a_table_of_times_is_said_before_anything_is_done() {
    let folder = env::temp_dir().join(format!("carom-study-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let table = folder.join("peers.csv");
    let header = "name,kind,scene,steps,nanoseconds,ratio,error\n";
    for (contents, message) in [
        (format!("{header}sympy,pear,oblique,,8e6,1,0\n"), "unknown kind `pear`"),
        (format!("{header}sympy,peer,oblique,,soon,1,0\n"), "`soon` is no time"),
        (format!("{header}sympy,peer\n"), "a row with 2 cells"),
        ("a,b\n".to_owned(), "this is no table of times"),
    ] {
        fs::write(&table, contents).unwrap();
        let (table, out) = (table.display().to_string(), folder.join("out"));
        let output = carom(&["study", "--peers", &table, "--out", &out.display().to_string()]);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains(message) && said.contains("peers.csv"), "{said}");
        assert!(!out.exists(), "nothing is written");
    }
    let missing = carom(&["study", "--times", "nowhere.csv"]);
    let said = String::from_utf8(missing.stderr).unwrap();
    assert!(said.contains("`nowhere.csv` cannot be read") && said.contains("help:"), "{said}");
    assert_eq!(carom(&["study", "--quick", "--times", "t.csv"]).status.code(), Some(2));
    fs::remove_dir_all(&folder).unwrap();
}
