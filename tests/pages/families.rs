//! A question of each family of the bank as it is printed: sheet, worked solution and mark scheme, diagrams and all, with
//! the numbers of its exercise.

use std::collections::BTreeMap;
use std::fs;

use carom::bank::{Bank, Question};
use carom::diagnostic::render_all;
use carom::generate::reference;
use carom::paper::{Paper, compose};
use carom::render::Formats;

use super::{folder, own};

/// Each format with one document more: the three of a paper without the heads that they share.
fn bodies() -> Formats {
    let latex = ["question", "solution", "scheme"]
        .map(|body| format!("<% for question in questions -%>\n<% include \"{body}.tex\" -%>\n<% endfor -%>\n"));
    let html = ["question", "solution", "scheme"]
        .map(|body| format!("{{% for question in questions -%}}\n{{% include \"{body}.html\" -%}}\n{{% endfor -%}}\n"));
    let text = ["question", "solution", "scheme", "answers"]
        .map(|body| format!("{{% for question in questions -%}}\n{{% include \"{body}.txt\" %}}\n{{% endfor -%}}\n"));
    let own_format = |name: &str, notation: &str, template: String| {
        let manifest = fs::read_to_string(folder().join(format!("../../templates/{name}/format.toml"))).unwrap();
        assert!(manifest.contains(&format!("notation = \"{notation}\"")), "{name}");
        let document = "\n[[documents]]\nfile = \"family\"\ntemplate = \"family\"\n";
        [own(&format!("{name}/format.toml"), &(manifest + document)), own(&format!("{name}/family"), &template)]
    };
    let prefix = "{% set prefix = \"\" -%}\n{% set document = \"\" -%}\n".to_owned();
    let formats = [
        own_format("latex", "latex", latex.concat()),
        own_format("html", "html", prefix + &html.concat()),
        own_format("text", "unicode", text.concat()),
    ];
    Formats::with(formats.into_iter().flatten()).unwrap_or_else(|fault| panic!("{fault}"))
}

#[test]
fn carom_knows_a_question_of_every_family_on_paper_and_on_screen() {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let mut families: BTreeMap<&str, &Question> = BTreeMap::new();
    for question in &bank.questions {
        families.entry(question.id.split('/').next().unwrap()).or_insert(question);
    }
    assert!(families.len() >= 5, "{:?}", families.keys());
    let formats = bodies();
    let accept = std::env::var_os("CAROM_ACCEPT").is_some();
    fs::create_dir_all(folder().join("families")).unwrap();
    let mut differing = Vec::new();
    for (family, question) in families {
        let variant = reference(question).unwrap_or_else(|_| panic!("{}", question.id));
        let paper = Paper { questions: vec![compose(question, &variant, 1)], ..Paper::default() };
        for (format, ending) in [("latex", "tex"), ("html", "html"), ("text", "txt")] {
            let rendered = formats.render(format, &paper).unwrap_or_else(|fault| panic!("{fault}"));
            let page = &rendered.iter().find(|file| file.name == "family").unwrap().contents;
            let name = format!("families/{family}.{ending}");
            if accept {
                fs::write(folder().join(&name), page).unwrap();
            } else if fs::read_to_string(folder().join(&name)).unwrap_or_default() != *page {
                differing.push(name);
            }
        }
    }
    assert!(differing.is_empty(), "{differing:?} differ from tests/pages/: CAROM_ACCEPT=1 writes them anew");
}
