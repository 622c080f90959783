//! Edits, and reasons for their refusal.

use serde::{Deserialize, Serialize};

use crate::model::{HookRole, LinkKind, Span};

/// An edit. In JSON an object whose `edit` is the name in small letters: `{"edit": "add_state", "component": "Player", "name":
/// "wait"}`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "edit", rename_all = "snake_case", deny_unknown_fields)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum Edit {
    /// Adds a state `name` after the function `after`, or after the last state.
    AddState {
        component: String,
        name: String,
        #[serde(default)]
        docs: String,
        #[serde(default)]
        initial: bool,
        #[serde(default)]
        last: bool,
        #[serde(default)]
        body: String,
        after: Option<String>,
    },
    /// Adds a transition `name` from the states `from` (`["*"]`: all) to the state `to`. If that state takes a found value, the
    /// transition returns an `Option` of it: `None` without `body`. Otherwise it returns `bool`: without `body` `false`, or with
    /// `after_ms` `true`.
    AddTransition {
        component: String,
        name: String,
        from: Vec<String>,
        to: String,
        after_ms: Option<u32>,
        #[serde(default)]
        body: String,
        #[serde(default)]
        docs: String,
        after: Option<String>,
    },
    /// Adds a hook `name`. Entry, exit and before hooks need `states`.
    AddHook {
        component: String,
        name: String,
        role: HookRole,
        #[serde(default)]
        states: Vec<String>,
        #[serde(default)]
        body: String,
        #[serde(default)]
        docs: String,
        after: Option<String>,
    },
    /// Adds functions as written, such as those copied from another component.
    InsertCode { component: String, code: String, after: Option<String> },
    /// Renames a function, the attributes that name it, and its uses in the file.
    Rename { component: String, function: String, to: String },
    /// Deletes a function; with a state also the transitions and hooks that only that state needs.
    Delete { component: String, function: String },
    /// Moves a function before another, or to the end.
    Move { component: String, function: String, before: Option<String> },
    /// Copies a function under another name, after the original. A copied state is not initial.
    Copy { component: String, function: String, name: String },
    /// Sets the initial state.
    SetInitial { component: String, state: String },
    /// Sets whether no transition leaves a state.
    SetLast { component: String, state: String, last: bool },
    /// Sets the word that marks a state as an end: `last`, `done` or `failed`.
    SetEnd { component: String, state: String, end: Option<String> },
    /// Adds a `#[transition]` to a condition, or to the state that it leaves; `when` is a result such as `failed(Reach)`.
    AddArrow {
        component: String,
        transition: String,
        from: Vec<String>,
        to: String,
        after_ms: Option<u32>,
        #[serde(default)]
        when: Option<String>,
    },
    /// Removes a `#[transition]` of several of a condition.
    RemoveArrow { component: String, transition: String, arrow: usize },
    /// Sets the states that a transition leaves.
    SetSources {
        component: String,
        transition: String,
        #[serde(default)]
        arrow: usize,
        from: Vec<String>,
    },
    /// Sets the state that a transition enters.
    SetTarget {
        component: String,
        transition: String,
        #[serde(default)]
        arrow: usize,
        to: String,
    },
    /// Sets or removes the minimum time in the state before a transition.
    SetTimer {
        component: String,
        transition: String,
        #[serde(default)]
        arrow: usize,
        after_ms: Option<u32>,
    },
    /// Sets or removes what a transition waits for: the `key` is `after`, a parameter such as `Approach::patience`, `when` or `times`.
    SetWait {
        component: String,
        transition: String,
        #[serde(default)]
        arrow: usize,
        key: String,
        value: Option<String>,
    },
    /// Sets the states of a hook of states.
    SetHookStates { component: String, hook: String, states: Vec<String> },
    /// Sets the code in the braces of a function; for a transition its condition.
    SetBody { component: String, function: String, body: String },
    /// Sets the doc comment of a function, or of the component.
    SetDocs { component: String, function: Option<String>, docs: String },
    /// Sets or removes an option; `resume` takes an empty value.
    SetOption { component: String, option: String, value: Option<String> },
    /// Adds a child to the signature of a function. `import` is the path of the module that has it.
    AddChild {
        component: String,
        function: String,
        child: String,
        kind: LinkKind,
        argument: Option<String>,
        import: Option<String>,
    },
    /// Removes a child from the signature of a function, and its import if nothing else uses it.
    RemoveChild { component: String, function: String, child: String },
    /// Sets the kind of the link to a child.
    SetChildKind { component: String, function: String, child: String, kind: LinkKind },
    /// Imports a name that code needs and that is no child, from the module `import`.
    AddImport { import: String, name: String },
    /// Sets the default of a parameter of the struct `parameters`.
    SetDefault { parameters: String, parameter: String, value: String },
    /// Sets numbers of a table of constants.
    SetNumbers { table: String, numbers: Vec<NewNumber> },
    /// Inserts a row before the row `before`, counted from 0, or at the end: a copy of the row `copy`, else the code `code`.
    InsertRow {
        table: String,
        before: usize,
        copy: Option<usize>,
        #[serde(default)]
        code: String,
    },
    /// Deletes a row, counted from 0.
    DeleteRow { table: String, row: usize },
    /// Renames a component that has a name of its own in a tree; without `to` removes it from the tree.
    RenameMember { tree: String, member: String, to: Option<String> },
    /// Sets the provider of a role of a tree; without `provider` removes the role from the tree.
    SetProvider { tree: String, role: String, provider: Option<String> },
    /// Renames a role and its uses in the file.
    RenameRole { role: String, to: String },
    /// Replaces a part of the text, as typing does.
    Replace { span: Span, text: String },
}

/// New number in a table of constants.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NewNumber {
    /// Row, counted from 0.
    pub row: usize,
    /// Name of the cell. In a row of pairs a new name adds a pair.
    pub cell: String,
    /// The number; `None` removes the pair.
    pub value: Option<f64>,
}

/// Reason for which an edit is not possible.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Refusal {
    /// Message with the remedy.
    pub message: String,
    /// Part of the text that prevents the edit.
    pub span: Option<Span>,
}

impl Refusal {
    /// Creates a refusal without a place.
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), span: None }
    }

    /// Creates a refusal with the part of the text that prevents the edit.
    pub fn at(span: Span, message: impl Into<String>) -> Self {
        Self { message: message.into(), span: Some(span) }
    }
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Refusal {}
