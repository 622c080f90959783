//! Holding components active or latent from outside.

/// What decides whether a component is active.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
#[cfg_attr(feature = "wire", serde(rename_all = "snake_case"))]
pub enum Hold {
    /// The tree: the component is active while an active component links to it.
    #[default]
    Tree,
    /// The hold: the component is active. If no active component links to it, it is visited after the root, activators first.
    Active,
    /// The hold: the component is latent. A visit ends there: its children are not visited through it, and components that
    /// read it read the values of its last run.
    Latent,
}
