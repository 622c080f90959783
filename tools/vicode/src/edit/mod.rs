//! Edits of the text: each becomes a few splices; all other bytes are kept.

mod children;
mod context;
mod create;
mod delete;
mod docs;
mod finder;
mod fragment;
mod functions;
mod imports;
mod layout;
mod machine;
mod options;
mod plan;
mod reads;
mod rename;
mod request;
mod role;
mod splice;
mod style;
mod table;
mod target;
mod tree;
mod types;
mod uses;

pub use self::create::{blank, declare, enlist, module_of};
pub use self::plan::plan;
pub use self::reads::reads;
pub use self::request::{Edit, NewNumber, Refusal};
pub use self::splice::{Splice, applied, inverse, ordered};
pub use self::style::DEFAULT_WIDTH;
pub use self::target::{Target, Use};
pub use self::uses::uses;
