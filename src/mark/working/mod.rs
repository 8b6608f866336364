//! Working looked through: what each line is, and which marks of the scheme it earns.
//!
//! Lines are read as answers are, in the question's letters and those that students give to what they look for. Then a
//! line is compared by what its formulas come to, not by how they look: at fixed points where letters remain, and within
//! the width that rounded figures leave open.

mod agreement;
mod along_wall;
mod angle_letters;
mod angles;
mod apiece;
mod by_components;
mod by_law;
mod change_of_momentum;
mod changed;
mod cleared;
mod compare;
mod components;
mod compound;
mod condition;
mod convention;
mod conventions;
mod critical;
mod crossed_out;
mod denied;
mod departure;
mod doubtful;
mod elastic;
mod energies;
mod evidence;
mod examine;
mod figures;
mod going_on;
mod impacts;
mod impulse;
mod in_answers;
mod line;
mod linear;
mod misread;
mod offered;
mod own;
mod own_condition;
mod own_letters;
mod own_speed;
mod pair;
mod points;
mod prepared;
mod printed;
mod products;
mod radians;
mod rebound;
mod remarks;
mod said;
mod shapes;
mod slipped;
mod solved;
mod spread;
mod squares;
mod substituted;
mod terms;
mod theirs;
mod told_apart;
mod trials;
mod turned;
mod two_lines;
mod values;
mod vector_momentum;
mod vectors;

pub(super) use examine::{Examined, has_these_sizes};
pub(super) use impacts::examine;
pub(super) use line::MOST_LINES;
pub(super) use misread::{Misread, numbers_of_masses};
pub(super) use prepared::Prepared;
pub(super) use theirs::Theirs;
