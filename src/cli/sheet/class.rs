//! A class: another sheet for each student, all in the same files, and a lock that remembers who got what.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use super::super::failure::{Failure, warn};
use super::super::formats::{FormatsAsked, Work};
use super::super::json_places::offset;
use super::super::output::{count, listed, say};
use super::super::text_file;
use super::super::write::OutputFile;
use super::choose::{checked, choose};
use super::earlier::STUDENTS;
use super::{SheetArguments, amiss, fresh_seed, json, paper, told, write_keyed};
use crate::bank::{Contents, Question, StyleName};
use crate::diagnostic::Diagnostic;
use crate::generate::Variant;
use crate::mark::report::file_names;
use crate::mark::submissions::empty_submissions_of_class;
use crate::paper::{Alike, ClassList, Key, KeyPaper, Lock, Locked, Paper, PlaceDealt, Sheet, Student, TooFew, deal};

/// What the lock is called beside the sheets.
const LOCK: &str = "lock.json";

/// Makes the sheets of a class.
pub(super) fn run(
    arguments: &SheetArguments,
    formats: &FormatsAsked,
    contents: &Contents,
    style: Option<StyleName>,
    list: &Path,
) -> Result<(), Failure> {
    if arguments.per_student {
        formats.has_for_each_student()?;
    }
    let list = ClassList::read(&text_file::text(list)?)?;
    warn(&list.warnings);
    let lock = OldLock::find(arguments)?;
    let seed = lock.as_ref().map_or_else(|| arguments.seed.unwrap_or_else(fresh_seed), |old| old.lock.seed);
    let chosen = choose(arguments, contents, style, seed)?;
    let questions = checked(&chosen)?;
    amiss::tell(arguments.bank.as_deref(), &questions, Some(seed), style);
    let in_order: Vec<&Question> = chosen.iter().filter_map(|heading| questions.get(heading.id.as_str())).collect();
    if let Some(old) = &lock {
        old.is_of(&in_order, style, arguments.seed)?;
        if old.lock.bank != contents.name {
            // A folder may have been moved, so that is no fault yet: the codes tell whether it is the same bank.
            let (path, bank) = (old.path.display(), &old.lock.bank);
            say(&format!("warning: `{path}` is of sheets from the bank `{bank}`, and this is `{}`", contents.name));
        }
    }
    let sheets = sheets(contents, &list.students, &in_order, style, seed, lock.as_ref())?;

    let shown: Vec<String> = list.students.iter().map(Student::shown).collect();
    let papers: Vec<Paper> = sheets
        .iter()
        .zip(&shown)
        .map(|(sheet, student)| paper(arguments, sheet, student.clone(), Some(seed)))
        .collect();
    let mut printed = formats.print(Work::Class(&papers), &arguments.out)?;
    let of_each = if arguments.per_student { per_student(formats, &papers)? } else { Vec::new() };
    printed.files.extend(of_each);
    let keyed = list.students.iter().zip(&sheets).map(|(student, sheet)| KeyPaper {
        student: student.id.clone(),
        name: student.name.clone(),
        code: sheet.code.to_string(),
        questions: sheet.keyed.clone(),
    });
    let key = Key::of_class(contents.name.clone(), Some(seed), keyed.collect());
    let remembered = remembered(contents, seed, &list.students, &sheets, lock.as_ref());
    keeps(&remembered, &arguments.out.join(LOCK))?;
    let empty = empty_submissions_of_class(&key.papers);
    let (printed, paths) = write_keyed(arguments, formats, printed, &key, empty, Some(json(LOCK, &remembered)?))?;

    let first = papers.first().map_or((0, 0), |paper| (paper.questions.len(), paper.marks()));
    let each = format!("{}, {} each", count(first.0, "question"), count(first.1, "mark"));
    say(&format!("{} of {each}, seed {seed}; `{LOCK}` remembers who got what", count(sheets.len(), "sheet")));
    told(printed, &paths)
}

/// A sheet for each student, in the order of the class: those of the lock again, and fresh ones.
fn sheets(
    contents: &Contents,
    students: &[Student],
    questions: &[&Question],
    style: Option<StyleName>,
    seed: u64,
    lock: Option<&OldLock>,
) -> Result<Vec<Sheet>, Failure> {
    let locked: Vec<Option<&Locked>> =
        students.iter().map(|student| lock.and_then(|old| old.lock.of(&student.id))).collect();
    let fresh = locked.iter().filter(|locked| locked.is_none()).count();
    let had: Vec<_> = lock.iter().flat_map(|old| &old.lock.sheets).map(Locked::hand).collect();
    let mut hands = Vec::new();
    if fresh > 0 {
        let class = deal(questions, fresh, seed, style, &had).map_err(|few| too_few(&few))?;
        class.places.iter().for_each(|place| tell(place, fresh));
        hands = class.hands;
    }
    if let Some(old) = lock {
        let again = count(students.len() - fresh, "sheet");
        say(&format!("{again} as `{}` has them, {} fresh", old.path.display(), fresh));
    }
    let mut fresh = hands.into_iter();
    let sheet = |hand: &[Variant]| Sheet::new(contents, questions.iter().copied().zip(hand));
    let mut sheets = Vec::with_capacity(students.len());
    for locked in locked {
        sheets.push(match locked {
            None => sheet(&fresh.next().unwrap_or_default()),
            Some(locked) => {
                let again = locked.variants(questions).map(|hand| sheet(&hand));
                again.filter(|again| again.code.to_string() == locked.code).ok_or_else(|| edited(locked))?
            }
        });
    }
    Ok(sheets)
}

/// Who has which sheet now; those who have left the class keep theirs, so that nobody else gets it.
fn remembered(contents: &Contents, seed: u64, students: &[Student], sheets: &[Sheet], old: Option<&OldLock>) -> Lock {
    let now = students.iter().zip(sheets).map(|(student, sheet)| Locked {
        student: student.id.clone(),
        name: student.name.clone(),
        code: sheet.code.to_string(),
        questions: sheet.dealt.clone(),
    });
    let present: HashSet<&str> = students.iter().map(|student| student.id.as_str()).collect();
    let left = old.iter().flat_map(|old| &old.lock.sheets).filter(|sheet| !present.contains(sheet.student.as_str()));
    let sheets = now.chain(left.cloned()).collect();
    Lock { carom: env!("CARGO_PKG_VERSION").to_owned(), bank: contents.name.clone(), seed, sheets }
}

/// Makes sure that the lock that lies beside the sheets, if it is not the one that was used, loses nobody.
fn keeps(new: &Lock, beside: &Path) -> Result<(), Failure> {
    if !beside.is_file() {
        return Ok(());
    }
    let old = OldLock::read(beside.to_owned())?.lock;
    let is_kept = |sheet: &&Locked| new.of(&sheet.student).is_some_and(|kept| kept.code == sheet.code);
    let lost: Vec<&str> =
        old.sheets.iter().filter(|sheet| !is_kept(sheet)).map(|sheet| sheet.student.as_str()).collect();
    match lost.as_slice() {
        [] => Ok(()),
        [student, others @ ..] => {
            let student = crate::expr::print::words_unicode(student);
            let and_others = if others.is_empty() { String::new() } else { format!(" and of {} more", others.len()) };
            Err(Failure::with_help(
                format!("`{}` would lose the sheet of `{student}`{and_others}", beside.display()),
                "name another folder with `--out`, or leave out `--lock`",
            ))
        }
    }
}

/// A lock that was written before.
struct OldLock {
    lock: Lock,
    path: PathBuf,
}

impl OldLock {
    /// The lock that the arguments name, or that lies beside the sheets.
    fn find(arguments: &SheetArguments) -> Result<Option<OldLock>, Failure> {
        let beside = arguments.out.join(LOCK);
        let path = match &arguments.lock {
            Some(path) => path.clone(),
            None if beside.is_file() => beside,
            None => return Ok(None),
        };
        OldLock::read(path).map(Some)
    }

    fn read(path: PathBuf) -> Result<OldLock, Failure> {
        let source = text_file::usually(&path, LOCK)?;
        match Lock::read(&source.text) {
            Ok(lock) if lock.is_later() => {
                let (path, own) = (path.display(), env!("CARGO_PKG_VERSION"));
                let message = format!("`{path}` was written by carom {}, and this is carom {own}", lock.carom);
                let help = format!("get carom {}, or name another folder with `--out` for fresh sheets", lock.carom);
                Err(Failure::with_help(message, help))
            }
            Ok(lock) => Ok(OldLock { lock, path }),
            Err(fault) => {
                let at = offset(&source.text, fault.place.0, fault.place.1).min(source.text.len());
                let message = format!("this is no lock of a class: {}", fault.message);
                let label = "expected what `carom sheet --class` has written";
                let help = "without the file all students get fresh sheets";
                let end = (at + 1).min(source.text.len());
                Err(Failure::Faults(vec![Diagnostic::new(message, &source, at..end, label).with_help(help)]))
            }
        }
    }

    /// Is it the lock of these questions, and of this seed and style if they are asked for?
    fn is_of(&self, questions: &[&Question], style: Option<StyleName>, seed: Option<u64>) -> Result<(), Failure> {
        let path = self.path.display();
        let help = "name the same questions again, or another folder with `--out` for fresh sheets";
        if let Some(seed) = seed.filter(|seed| *seed != self.lock.seed) {
            let message = format!("`{path}` is of sheets with seed {}, not {seed}", self.lock.seed);
            return Err(Failure::with_help(message, "leave out `--seed`, or name another folder with `--out`"));
        }
        for sheet in &self.lock.sheets {
            let ids: Vec<&str> = sheet.questions.iter().map(|question| question.id.as_str()).collect();
            if !ids.iter().eq(questions.iter().map(|question| &question.id)) {
                let message = format!("`{path}` is of sheets with other questions: {}", listed(ids));
                return Err(Failure::with_help(message, help));
            }
            if let Some(style) = style.filter(|style| sheet.hand().iter().any(|(had, _)| had != style)) {
                return Err(Failure::with_help(format!("`{path}` is of sheets in another style than `{style}`"), help));
            }
        }
        Ok(())
    }
}

/// The files of each paper by itself, in a folder of the student's.
fn per_student(formats: &FormatsAsked, papers: &[Paper]) -> Result<Vec<OutputFile>, Failure> {
    let folders = file_names(papers.iter().map(|paper| paper.student.as_str()));
    let mut files = Vec::new();
    for (paper, folder) in papers.iter().zip(folders) {
        for file in formats.render(Work::Sheet(paper))? {
            files.push(OutputFile { name: format!("{STUDENTS}/{folder}/{}", file.name), ..file });
        }
    }
    Ok(files)
}

/// Says how far the variants of a question are alike, if not in all, and that their answers are if they must be.
fn tell(place: &PlaceDealt, students: usize) {
    let (question, style) = (&place.question, place.style);
    if place.different < students {
        let others = count(place.different, "different answer");
        say(&format!(
            "`{question}`: {others} for {}: too few {style} variants of one kind differ in them",
            count(students, "student")
        ));
    }
    match place.alike {
        Alike::Wholly => {}
        Alike::ButForE => {
            say(&format!("`{question}`: e is not the same for all: too few {style} variants of one kind share it"));
        }
        Alike::InStyle => {
            say(&format!("`{question}`: the students share only the style {style}: too few variants are of one kind"));
        }
    }
}

fn too_few(few: &TooFew) -> Failure {
    let TooFew { question, style, left, needed, costliest } = few;
    let message =
        format!("`{question}` has {left} {style} sets of numbers to deal, and {needed} students need one each");
    let help = match costliest {
        Some((reason, away, size)) => {
            format!(
                "most are turned away since {reason}: {away} of {size}; take another question or `--style`, or relax that"
            )
        }
        None => "take another question, or another `--style`".to_owned(),
    };
    Failure::with_help(message, help)
}

fn edited(locked: &Locked) -> Failure {
    let student = crate::expr::print::words_unicode(&locked.student);
    Failure::with_help(
        format!("the sheet {} of `{student}` cannot be printed again: the bank has been edited since", locked.code),
        "name the bank from which it was printed, with `--bank`",
    )
}
