//! No answer takes long to judge, however it is made: counted in steps of arithmetic, never by a clock.

use super::*;
use crate::mark::reading::{LONGEST, read_answer};
use crate::number::{Letter, Range, steps};

/// Models of every kind: text and kind.
const MODELS: [(&str, Option<Kind>); 14] = [
    ("4*sqrt(39)/9", None),
    ("2*cos(20*deg)", None),
    ("u*(1-e)*cos(theta)/(2*m)", None),
    ("u*sqrt(cos(theta)^2+e^2*sin(theta)^2)", None),
    ("(1+e)*tan(alpha)/(2*tan(alpha)^2+1-e)", None),
    ("4*i+sqrt(3)*j", None),
    ("u*i-e*u*j/2", None),
    ("atan(3*sqrt(3)/5)", Some(Kind::Angle)),
    ("2*v+3*w=4*u", None),
    ("m*u*cos(theta)=m*v+2*m*w", None),
    ("2/3", Some(Kind::Ratio)),
    ("i-3*j", Some(Kind::Line)),
    ("[2*sqrt(3), 2]", Some(Kind::Velocity)),
    ("tan(beta)=2*tan(alpha)/(1-e)", Some(Kind::Shown)),
];

/// Formulas that are short to write and long to work out.
const LABORIOUS: [&str; 69] = [
    // Halves of halves: a root in a root for each.
    "θ½½½½½½",
    "tan(θ/2/2/2/2/2/2)",
    "sin(α½½+β½½½)",
    // A long trial for factors, of a value that has no reciprocal.
    "0√100100000000090000",
    "0/⅓abssqrtabs100100000000090000",
    "((2^16)^16)^16",
    "(((((((9^16)^16)^16)^16)^16)^16)^16)^16",
    "((1.23456789^16)^16)^16",
    "(((u+1)^16)^16)^16",
    "(u+e+m+v+w)^16",
    "(u+e+cosθ+sinθ+tanθ)^16/(1+e)^16",
    "((u+e)^16)*((u+m)^16)*((v+e)^16)",
    "√((u+e+cosθ)^16+1)",
    "√(u+√(e+√(m+√(v+√w))))",
    "(√2+√3+√5+√7+√11+√13+√17+√19+√23+√29+√31+√37)^16",
    "1/(√2+√3+√5+√7+√11+√13+√17+√19+√23+√29+√31+√37)",
    "((√2+√3+√5+√7)^16+1)^16",
    "√(2+√(3+√(5+√(7+√(11+√(13+√(17+√19)))))))",
    "√2√3√5√7√11√13√17√19√23√29√31√37√41√43",
    "√(u+e+2√(u*e))+√(e+v+2√(e*v))+√(v+w+2√(v*w))-√u-2√e-2√v-√w",
    "√(u+e+2√(u*e))+√(e+m+2√(e*m))=√u+2√e+√m",
    "√(8+2√15)+√(10+2√21)+√(18+2√77)+√(24+2√143)-2√3-√5-2√7-2√11-√13",
    "√(u^2+1)+√(u^2+e)+√(m^2+3)+√(1+cosθ)",
    "1/(√(u^2+v^2)+√(e^2+1)+√(m^2+3)+√(1+cosθ))",
    "1/(u+e)+1/(u+2e)+1/(u+3e)+1/(u+4e)+1/(u+5e)+1/(u+6e)+1/(u+7e)+1/(u+8e)+1/(u+9e)",
    "1/(u+e+m)^8+1/(u+2e+m)^8+1/(u+3e+m)^8+1/(u+4e+m)^8",
    "sin(99999999999999999999)",
    "sin(10^20)+sin(10^19)",
    "sin(((10^20)^16)^16)",
    "cos(20)-cos(40)-cos(80)",
    "(cos(20)-cos(40)-cos(80))(√2+√3+√5+√7+√11+√13)",
    "cos(1/97)*sin(1/97)*2-sin(2/97)",
    "1/(cos(1/97)*sin(1/97)*2-sin(2/97))",
    "√(cos(0.01)-cos(0.02)*cos(0.01)-sin(0.01)*sin(0.02))",
    "|cos(0.0001)*sin(0.0001)*2-sin(0.0002)|",
    "sin(1/3)^16+sin(1/5)^16",
    "sin(1)sin(2)sin(3)sin(5)sin(7)sin(11)sin(13)sin(17)",
    "1/(sin(1)+sin(2)+sin(3))",
    "cos(12θ)+cos(11θ)",
    "cos(99999θ)",
    // A multiple of a multiple of a multiple.
    "9 (4θ)x6(6)",
    "12(12(12θ))",
    "tan(12θ)",
    "tan(θ+α+β)",
    "sin(3θ+4α+5β)",
    "arctan(√2+√3)+arctan(√5)+arctan(√7)+arctan(1/3)",
    "arctan(arctan(arctan(0.1)))",
    "arctan(tan(12θ))",
    "sin(arctan(√2)+arctan(√3)+arctan(√5))",
    "sin46.11/(4360u)",
    "m^tan3=0",
    "11arctan(¾^12*sin²(¾)*¾^14)",
    "arctan(3√3/(5hke))=46.1",
    "12arctan(0.123456^5*sin²(θ)*¾^14+sin(13)^5*√2)",
    "7arctan(u/e)+5arctan(e/2)+3arctan(1+√2)",
    "arctan(3√3u/5)=46.1",
    "√123456789012345678901234567891",
    "√(123456789012345678901234567891*987654321098765432109876543211)",
    "√((10^20+39)*(10^20+129))+√((10^20+39)*(10^20+130))",
    "√99999999999999999999+√99999999999999999997+√99999999999999999989+√99999999999999999971",
    "0.12345678901234567890123456789/0.98765432109876543210987654321",
    "(u+v+w+e)^12=(u-v+w)^12",
    "√u+√v+√w=√m+√e+√(u+v)+√(v+w)",
    "v=(u+w)^16/(w+e)^16+√(u+v)",
    "√(1+tanα)+√(1+tanβ)+√(1+e)=√(tanα+tanβ)",
    "(1+tanα)^16=(tanβ+e)^16",
    "(√2+√3+√5)i+(√7+√11)j",
    "((u+e)^16i+(√7+√11)^16j)/(√2+√3)",
    "e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e^e",
];

/// Pieces that are repeated until the answer is as long as any that is read.
const REPEATED: [&str; 44] = [
    "½",
    "(",
    "√",
    "√2+",
    "√(1+",
    "9^9^",
    "2^16*",
    "(1+√2)",
    "(u+e)^16*",
    "(1+e)^16",
    "1/2v+",
    "1/(1+√",
    "2/3/",
    "i+j+",
    "1=",
    "1,",
    "2,5;",
    "1,5+",
    "1 so ",
    "1 or ",
    "A = 1, ",
    "1.2e3+",
    "2·3+",
    "0.333...+",
    "2.77...+",
    "sin x/2+",
    "sin(1)+",
    "arctan ",
    "in the direction of ",
    "perpendicular to ",
    "1 to the line of centres ",
    "9mJ+",
    "3 1/2+",
    "√99999999999999999999+",
    "1e20*",
    "(√2+√3)*",
    "1/(√2+√3)+",
    "1/(1+u)+",
    "cosθ/(1+sinθ)+",
    "e^",
    "gradient 1 ",
    "tanβ",
    "3√3/5",
    "3√3/53√3/5√√",
];

/// The most steps that judging one answer may take. A step is an operation on short numbers; so many are
/// about two milliseconds.
const MOST_STEPS: u64 = 150_000;

/// Each with letters that the question has beside those of the model.
fn models() -> Vec<(&'static str, Model)> {
    let beside = [("u", Range::Positive), ("e", Range::Unit), ("theta", Range::Acute)];
    let beside: Vec<Letter> = beside.map(|(name, range)| Letter::new(name, range).unwrap()).into();
    let read = |(text, kind): &(&'static str, Option<Kind>)| {
        let options = ModelOptions { kind: *kind, letters: beside.clone(), ..ModelOptions::default() };
        (*text, Model::read(text, &options).unwrap())
    };
    MODELS.iter().map(read).collect()
}

/// Each formula alone, and where it makes no difference to the right answer.
fn disguises(model: &str, formula: &str) -> Vec<String> {
    let right = model.split('=').next_back().unwrap_or(model).replace("*deg", "°");
    vec![
        formula.to_owned(),
        format!("{right}+0*({formula})"),
        format!("{right}+({formula})-({formula})"),
        format!("({right})*({formula})/({formula})"),
        format!("({formula})i+({formula})j"),
        format!("({formula}):({formula})"),
        format!("v=({formula})w"),
        format!("arctan({formula})"),
        format!("{right}={right}+0({formula})"),
    ]
}

#[test]
fn no_answer_takes_long_to_judge() {
    let mut worst: Vec<(u64, String)> = Vec::new();
    for (text, model) in &models() {
        let mut answers: Vec<String> = LABORIOUS.iter().flat_map(|formula| disguises(text, formula)).collect();
        for piece in REPEATED {
            for length in [60, 300, LONGEST - 1] {
                let answer = piece.repeat(length / piece.len());
                answers.extend([format!("{answer}1"), format!("{answer}=0=1=0"), answer]);
            }
        }
        // An equation in one unknown, read in several ways, and a chain of values for it.
        let tangents = |count: usize| "tanβ".repeat(count);
        let [first, second, third, last] = [28, 6, 26, 8].map(tangents);
        answers.push(format!("133{first}arctan0000000{second}–0000000{third}arctan0000000{last}=0=1=0"));
        // Small beyond 64 binary places, and in it a root in a root in a root.
        let [first, last] = [13, 9].map(|count| "3√3/5".repeat(count));
        for depth in [4, 8, 10, 11] {
            let roots = "√".repeat(depth);
            answers.push(format!("3√3/54u{first}{roots}3√3/52.782"));
            answers.push(format!("3√3/54u{first}{roots}3√3/52.782from BA{last}"));
        }
        for answer in answers {
            let readings = read_answer(&answer, &model.vocabulary);
            judge(model, &readings);
            steps::taken();
            judge(&model.of_value(model.value.clone()), &readings);
            worst.push((steps::taken(), format!("{answer:.80} for {text}")));
        }
    }
    worst.sort_by_key(|(steps, _)| std::cmp::Reverse(*steps));
    let above = worst.iter().take_while(|(steps, _)| *steps > MOST_STEPS);
    let above: Vec<String> = above.map(|(steps, answer)| format!("{steps} steps: {answer}")).collect();
    assert!(above.is_empty(), "{} of {}:\n{}", above.len(), worst.len(), above[..above.len().min(60)].join("\n"));
}
