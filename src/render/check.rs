//! The check of a format's templates: every name that they ask for is looked up, also where no paper would come to it.
//!
//! Documents are followed as Tera follows them: a loop names what its list is a list of, an included template sees the
//! names at the place of its `include`, a component sees what it is given. So one template may be looked at many times.

use std::collections::{BTreeMap, BTreeSet};

use super::code::{Code, Word, read};
use super::expression::Reading;
use super::lookup::Found;
use super::manifest::{Marks, Sees};
use super::names::Kind;
use super::scope::Scope;
use crate::diagnostic::{Diagnostic, Source};

/// What a check brings to light.
#[derive(Debug, Default)]
pub(super) struct Checked {
    /// Names that there are not, each reported once.
    pub faults: Vec<Diagnostic>,
    /// Names that some document asks for, each with its thing; `None` if a thing is used as a whole.
    pub used: Option<BTreeSet<(&'static str, &'static str)>>,
    /// Files that some document comes to.
    pub reached: BTreeSet<String>,
}

/// Checks the documents of a format, each with what it sees, and what they include, extend and call.
pub(super) fn check(
    files: &BTreeMap<String, Source>,
    folder: &str,
    documents: &[(&str, Sees)],
    marks: &Marks,
) -> Checked {
    let codes = files.iter().map(|(file, source)| (file.as_str(), read(&source.text, marks))).collect();
    let mut walk = Walk {
        files,
        folder,
        codes: &codes,
        components: components(&codes),
        seen: BTreeSet::new(),
        found: Found::default(),
    };
    for (document, sees) in documents {
        let scope = match sees {
            Sees::Paper => Scope::page(),
            Sees::Class => Scope::only("class"),
            Sees::Feedback => Scope::only("feedback"),
            Sees::Report => Scope::only("report"),
        };
        walk.template(document, scope);
    }
    let reached: BTreeSet<String> = walk.seen.iter().map(|(file, ..)| (*file).to_owned()).collect();
    // a component that nobody calls may be called tomorrow
    for component in walk.components.clone().into_values() {
        if !walk.seen.iter().any(|(file, begin, _)| (*file, *begin) == (component.file, component.begin)) {
            walk.component(&component, &BTreeMap::new(), &Scope::of(BTreeMap::new()));
        }
    }
    let mut faults: Vec<Diagnostic> = Vec::new();
    for fault in walk.found.faults {
        if !faults.iter().any(|known| known.source.file == fault.source.file && known.span == fault.span) {
            faults.push(fault);
        }
    }
    Checked { faults, used: (!walk.found.whole).then_some(walk.found.used), reached }
}

/// All code of all templates.
type Codes<'t> = BTreeMap<&'t str, Vec<Code<'t>>>;

/// A component where it is defined.
#[derive(Clone, Debug)]
struct Component<'t> {
    file: &'t str,
    /// The place of its first piece of code.
    begin: usize,
    /// What it may be given; what is taken from the caller without being given is marked.
    takes: Vec<(&'t str, bool)>,
}

struct Walk<'w, 't> {
    files: &'t BTreeMap<String, Source>,
    folder: &'w str,
    codes: &'w Codes<'t>,
    components: BTreeMap<String, Component<'t>>,
    /// Pieces of templates with the names that they have been looked at with.
    seen: BTreeSet<(&'t str, usize, Scope<'t>)>,
    found: Found<'t>,
}

/// What a closing block closes.
#[derive(PartialEq)]
enum Open<'t> {
    If,
    Loop,
    /// What follows the `else` of a loop.
    LoopElse,
    /// A block that is kept under a name.
    Set {
        name: &'t str,
        global: bool,
    },
}

impl<'t> Walk<'_, 't> {
    /// A template by its path in the folder, where these names are.
    fn template(&mut self, file: &str, scope: Scope<'t>) -> Scope<'t> {
        self.piece(file, 0, scope)
    }

    /// The file that an `include` or `extends` means, as Tera looks for it.
    fn resolve(&self, name: &str) -> Option<&'t str> {
        let inside = name.strip_prefix(self.folder).and_then(|rest| rest.strip_prefix('/'));
        let known = |path: &str| self.files.get_key_value(path).map(|(file, _)| file.as_str());
        inside.and_then(known).or_else(|| known(name))
    }

    /// A template from a piece of code on, up to its end or the end of the component.
    fn piece(&mut self, file: &str, begin: usize, mut scope: Scope<'t>) -> Scope<'t> {
        let Some((file, source)) = self.files.get_key_value(file).map(|(file, source)| (file.as_str(), source)) else {
            return scope;
        };
        if !self.seen.insert((file, begin, scope.clone())) {
            return scope;
        }
        let codes = &self.codes[file][begin..];
        for name in globals(codes) {
            if scope.get(name).is_none() {
                scope.set_global(name, Kind::Anything);
            }
        }
        let mut open = Vec::new();
        let mut in_component = false;
        for code in codes {
            let (words, is_block) = match code {
                Code::Printed(words) => (words, false),
                Code::Block(words) => (words, true),
            };
            let first = words.first().map_or("", |word| word.text);
            match (is_block, first) {
                (true, "endcomponent") if !in_component => return scope,
                (true, "component" | "endcomponent") => in_component = first == "component",
                _ if in_component => {}
                (true, "include") => {
                    if let Some(included) = words.get(1).and_then(|word| self.resolve(word.quoted()?)) {
                        self.template(included, scope.included());
                    }
                }
                (true, "extends") => {
                    if let Some(parent) = words.get(1).and_then(|word| self.resolve(word.quoted()?)) {
                        scope = self.template(parent, scope);
                    }
                }
                (is_block, _) => self.code(words, is_block, source, &mut scope, &mut open),
            }
            for (name, given) in std::mem::take(&mut self.found.calls) {
                if let Some(component) = self.components.get(&name).cloned() {
                    self.component(&component, &given, &scope);
                }
            }
        }
        scope
    }

    /// One piece of code: what it prints, asks and names.
    fn code(
        &mut self,
        words: &[Word<'t>],
        is_block: bool,
        source: &Source,
        scope: &mut Scope<'t>,
        open: &mut Vec<Open<'t>>,
    ) {
        let before = scope.clone();
        let mut reading = Reading { words, at: 0, scope: &before, source, found: &mut self.found };
        if !is_block {
            let value = reading.expression();
            reading.found.as_whole(value);
            return;
        }
        let Some(first) = reading.next() else { return };
        match first.text {
            "if" | "elif" => {
                let condition = reading.expression();
                reading.found.truth(condition);
                if first.text == "if" {
                    open.push(Open::If);
                }
            }
            "for" => {
                let names = reading.loop_names();
                let list = reading.expression();
                scope.enter_loop(reading.bind(&names, list));
                open.push(Open::Loop);
            }
            "else" if open.last() == Some(&Open::Loop) => {
                scope.leave_loop();
                open.pop();
                open.push(Open::LoopElse);
            }
            "endfor" => {
                let closed = open.pop();
                if closed == Some(Open::Loop) {
                    scope.leave_loop();
                }
            }
            "endif" => {
                open.pop();
            }
            "set" | "set_global" => {
                let global = first.text == "set_global";
                let Some(name) = reading.next() else { return };
                if !reading.take("=") {
                    open.push(Open::Set { name: name.text, global });
                    return;
                }
                let value = reading.expression();
                // where a branch sets it, it may also be what it was
                let in_branch = open.contains(&Open::If) || global && before.in_loop();
                let kind = match before.get(name.text) {
                    Some(earlier) if in_branch => reading.found.either(earlier, value),
                    _ => value,
                };
                if global { scope.set_global(name.text, kind) } else { scope.set(name.text, kind) }
            }
            "endset" => match open.pop() {
                Some(Open::Set { name, global: true }) => scope.set_global(name, Kind::Plain),
                Some(Open::Set { name, global: false }) => scope.set(name, Kind::Plain),
                _ => {}
            },
            "<" => reading.component(),
            _ => {}
        }
    }

    /// A component that is called in a place with these names.
    fn component(&mut self, component: &Component<'t>, given: &BTreeMap<&'t str, Kind>, place: &Scope<'t>) {
        let mut names = BTreeMap::from([("body", Kind::Plain)]);
        for (takes, from_caller) in &component.takes {
            let from_caller = from_caller.then(|| place.get(takes)).flatten();
            names.insert(*takes, given.get(takes).copied().or(from_caller).unwrap_or(Kind::Anything));
        }
        self.piece(component.file, component.begin, Scope::of(names));
    }
}

/// Names that the code sets for the whole template, so that a loop may ask for them before.
fn globals<'t>(codes: &[Code<'t>]) -> Vec<&'t str> {
    let set = |code: &Code<'t>| match code {
        Code::Block(words) if words.first()?.text == "set_global" => Some(words.get(1)?.text),
        _ => None,
    };
    codes.iter().filter_map(set).collect()
}

/// The components that templates define: `component name(a, b: string = "x", @c, ...rest)`.
fn components<'t>(codes: &Codes<'t>) -> BTreeMap<String, Component<'t>> {
    let mut components = BTreeMap::new();
    for (file, codes) in codes {
        for (place, code) in codes.iter().enumerate() {
            let Code::Block(words) = code else { continue };
            if words.first().map(|word| word.text) != Some("component") {
                continue;
            }
            let name: String = words[1..].iter().take_while(|word| word.text != "(").map(|word| word.text).collect();
            components.insert(name, Component { file, begin: place + 1, takes: takes(words) });
        }
    }
    components
}

/// What the head of a component says that it takes.
fn takes<'t>(head: &[Word<'t>]) -> Vec<(&'t str, bool)> {
    let mut takes = Vec::new();
    let mut depth = 0;
    for pair in head.windows(2) {
        let [before, word] = pair else { continue };
        if depth == 1 && word.is_name() && matches!(before.text, "(" | "," | "@" | "...") {
            takes.push((word.text, before.text == "@"));
        }
        match word.text {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
    }
    takes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checked(files: &[(&str, &str)]) -> Checked {
        let source = |(file, text): &(&str, &str)| ((*file).to_owned(), Source::new(*file, *text));
        check(&files.iter().map(source).collect(), "format", &[(files[0].0, Sees::Paper)], &Marks::default())
    }

    /// The words under the carets.
    fn unknown(files: &[(&str, &str)]) -> Vec<String> {
        let marked = |fault: &Diagnostic| fault.source.text[fault.span.clone()].to_owned();
        checked(files).faults.iter().map(marked).collect()
    }

    #[test]
    fn carom_knows_a_misspelt_name_wherever_it_stands() {
        let cases: [(&str, &[&str]); 30] = [
            ("{{ title }} {{ titel }}", &["titel"]),
            ("{{ question.number }}", &["question"]),
            ("{% if seed and not titel %}never{% elif dat %}{% endif %}", &["titel", "dat"]),
            ("{% for q in questions %}{{ q.number }}{{ q.nummer }}{% endfor %}{{ q }}", &["nummer", "q"]),
            ("{% for q in questions %}{% if q.mirors %}x{% endif %}{% endfor %}", &["mirors"]),
            (
                "{% for q in questions %}{% for p in q.parts %}{{ p.ask }}{{ p.stem }}{% endfor %}{% endfor %}",
                &["stem"],
            ),
            ("{%- for x in questions[0].parts -%}{{-x.scheme[0].kode-}}{% endfor %}", &["kode"]),
            ("{% for q in questions | reverse %}{{ q['id'] }}{{ q['ide'] }}{% endfor %}", &["'ide'"]),
            ("{% for q in questions[1:] %}{{ q.nummer }}{% endfor %}", &["nummer"]),
            (
                "{% for q in questions %}{{ loop.index }}{% else %}{{ q.number }}{{ loop.last }}{% endfor %}",
                &["q", "loop"],
            ),
            ("{{ loop.first }}", &["loop"]),
            ("{% set all = questions %}{% for q in all %}{{ q.nummer }}{% endfor %}", &["nummer"]),
            ("{% set q = questions | first %}{{ q.nummer }}{{ q?.mark }}", &["nummer", "mark"]),
            ("{% for q in questions %}{% set n = q.number %}{{ n }}{% endfor %}{{ n }}", &["n"]),
            ("{% for q in questions %}{% if last %}{{ last }}{% endif %}{% set_global last = q.id %}{% endfor %}", &[]),
            ("{% set head %}{{ titel }}{% endset %}{{ head | upper }}{{ haed }}", &["titel", "haed"]),
            ("{% if seed %}{% set x = questions %}{% else %}{% set x = marks %}{% endif %}{{ x.whatever }}", &[]),
            ("{% set x = title %}{% if seed %}{% set x = questions %}{% endif %}{{ x.whatever }}", &[]),
            ("{{ title.length }}", &["length"]),
            ("{{ questions.parts }}", &["parts"]),
            ("{% for k, v in questions %}{{ k }}{{ v.number }}{% endfor %}", &["k"]),
            ("{{ [q.number for q in questions if q.markz > 1] | join(sep=sepp) }}", &["markz", "sepp"]),
            ("{{ [titel, ...questions] | length }}{{ {'a': dat, 'b': 1} | length }}", &["titel", "dat"]),
            (
                "{{ questions | sort(attribute='marks') | length }}{{ questions | sort(attribute='mark') | length }}",
                &["'mark'"],
            ),
            ("{{ range(end=markz) | length }}{{ title is starting_with(pat=dat) }}", &["markz", "dat"]),
            ("{{ title if seed else dat }}{{ marks + markz * 2 }}{{ 'titel' ~ \"}} {{ dat\" }}", &["dat", "markz"]),
            ("{% raw %}{{ titel }}{% endraw %}{# {{ titel }} #}{{ date | default(value=dat) }}", &["dat"]),
            ("{% filter upper | replace(from=titel, to='') %}{{ dat }}{% endfilter %}", &["dat"]),
            (
                "{% for x in question.stem %}{% endfor %}{% for q in questions %}{% for s in q.stem %}{{ s.x }}{% endfor %}{% endfor %}",
                &["question", "x"],
            ),
            ("{{ __tera_context }}{% block a %}{{ titel }}{% endblock a %}", &["titel"]),
        ];
        for (template, expected) in cases {
            let compiled = tera::Tera::new().add_raw_template("t", template);
            assert!(compiled.is_ok(), "{template}: {compiled:?}");
            assert_eq!(unknown(&[("t", template)]), expected, "{template}");
        }
    }

    #[test]
    fn carom_sees_an_included_template_where_it_is_included() {
        let both = "{% for q in questions %}{% include 'one' %}{% endfor %}";
        assert_eq!(unknown(&[("t", both), ("one", "{{ q.id }}{{ q.nummer }}{{ loop.index }}")]), ["nummer", "loop"]);
        let outside = [("t", "{% include 'format/one' %}"), ("one", "{{ q.id }}")];
        assert_eq!(unknown(&outside), ["q"]);
        let set_within = [("t", "{% include 'one' %}{{ x }}"), ("one", "{% set x = title %}{{ x }}")];
        assert_eq!(unknown(&set_within), ["x"]);
        let extended =
            [("t", "{% extends 'base' %}{% block a %}{{ x }}{{ titel }}{% endblock %}"), ("base", "{% set x = 1 %}")];
        assert_eq!(unknown(&extended), ["titel"]);
    }

    #[test]
    fn carom_sees_a_component_with_what_it_is_given() {
        let define = "{% component row(q, n: integer = 1, @seed, ...rest) %}{{ q.id }}{{ q.nummer }}{{ n }}{{ seed }}{{ rest }}\
            {{ body }}{{ title }}{% endcomponent row %}";
        let call = "{% for q in questions %}{{ <row q={q} n={1}/> }}{% <row q={q.parts[0]}> %}{{ titel }}{% </row> %}{% endfor %}";
        assert_eq!(unknown(&[("t", call), ("row", define)]), ["nummer", "title", "id", "titel"]);
        assert_eq!(unknown(&[("t", ""), ("row", define)]), ["title"]);
        assert!(checked(&[("t", call), ("row", define)]).reached.contains("row"));
    }

    #[test]
    fn carom_knows_what_templates_ask_for_and_which_are_asked() {
        let files = [
            ("t", "{% for q in questions %}{% include 'one' %}{% endfor %}"),
            ("one", "{{ q.id }}"),
            ("two", "{{ date }}"),
        ];
        let found = checked(&files);
        assert_eq!(found.used, Some(BTreeSet::from([("", "questions"), ("question", "id")])));
        assert_eq!(found.reached, BTreeSet::from(["t".to_owned(), "one".to_owned()]));
        let whole = [
            "{{ questions }}",
            "{% for q in questions %}{% if q %}{% endif %}{% endfor %}",
            "{{ questions | group_by(attribute='id') | length }}",
            "{% for q in questions %}{{ q == title }}{% endfor %}",
            "{% for q in questions %}{% for k, v in q %}{{ v }}{% endfor %}{% endfor %}",
        ];
        for template in whole {
            assert_eq!(checked(&[("t", template)]).used, None, "{template}");
        }
    }
}
