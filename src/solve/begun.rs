//! A scene followed as far as somebody asks, and solved only if he wants all of it.

use std::sync::Arc;

use super::Solution;
use super::answer_path::{AnswerPath, answer_path};
use crate::mechanics::{ALONG, Derivation, Found, Known, Quantity, Refusal, Scene, check_on, pose};
use crate::number::{Angle, Value};

/// A scene without unknowns, and what has been derived from it so far. Whether it can happen is known when it is solved.
///
/// Of a hundred sets of numbers that a question tries most are turned away by a single quantity that is not simple enough:
/// with them there is no more to do than to find it.
///
/// ```
/// use carom::bank::read_scene;
/// use carom::diagnostic::Source;
/// use carom::solve::Begun;
/// let text = r#"
///     masses = { A = "2", B = "3" }
///     e = "1/2"
///     line_of_centres = ["1", "0"]
///     before = { A = ["3", "4"], B = ["0", "0"] }
/// "#;
/// let scene = read_scene(&Source::new("scene.toml", text)).unwrap();
/// let mut begun = Begun::new(scene.into()).unwrap().expect("it has no unknowns");
/// let speed = "A.before.speed".parse().unwrap();
/// begun.derive(&[speed]);
/// assert_eq!(begun.number(speed), Some(5.into()));
/// ```
#[derive(Clone, Debug)]
pub struct Begun {
    scene: Arc<Scene>,
    given: Known<Value>,
    /// What is given, and after it what has been derived.
    known: Known<Value>,
    /// How the components after the impact were found, once that has been tried.
    path: Option<Option<AnswerPath>>,
}

impl Begun {
    /// Begins; none where the scene has unknowns, of which all that follows depends.
    ///
    /// # Errors
    ///
    /// What is given contradicts itself, or cannot happen whatever follows from it.
    pub fn new(scene: Arc<Scene>) -> Result<Option<Begun>, Refusal> {
        if !scene.unknowns.is_empty() || !scene.conditions.is_empty() || scene.maximise.is_some() {
            return Ok(None);
        }
        let given = pose(&scene).map_err(|refusal| refusal.said_of(scene.setting))?;
        let known = given.clone();
        Ok(Some(Begun { scene, given, known, path: None }))
    }

    /// Derives those of some quantities that are determined.
    pub fn derive(&mut self, asked: &[Quantity]) {
        let Begun { given, known, path, .. } = self;
        if asked.iter().all(|quantity| known.0.contains_key(quantity)) {
            return;
        }
        let given = given.0.len();
        Derivation::carry_on_with(known, given, asked, &mut |step, known| {
            if step.gives.iter().any(|quantity| ALONG[2..].contains(quantity)) {
                path.get_or_insert_with(|| answer_path(known, given));
            }
        });
    }

    /// A quantity that is a number, if it has been derived.
    pub fn number(&self, quantity: Quantity) -> Option<Value> {
        self.known.number(quantity)
    }

    /// A quantity that is an angle, if it has been derived.
    pub fn angle(&self, quantity: Quantity) -> Option<Angle> {
        let (y, x) = self.known.direction(quantity)?;
        Angle::of(&y, &x)
    }

    /// Its solution.
    ///
    /// # Errors
    ///
    /// As for [`super::solve`].
    pub fn solve(self, asked: &[Quantity]) -> Result<Solution, Refusal> {
        let Begun { scene, given, mut known, path } = self;
        let path = path.unwrap_or_else(|| answer_path(&mut known, given.0.len()));
        let setting = scene.setting;
        let known = check_on(&given, known).map_err(|refusal| refusal.said_of(setting))?;
        Solution::of(Found::given(scene), given, path, &known, asked).with_all_asked()
    }
}
