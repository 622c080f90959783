//! Messages about `activation_tree!`.

pub(crate) const TREE_FORM: &str = "write `pub struct Name { root: ..., cycle_hz: ..., components: [...] }`";
pub(crate) const TREE_GENERIC: &str = "a tree has no parameters, it lists concrete components: remove this";
pub(crate) const TREE_CONDITION: &str = "put the condition on the macro: `#[cfg(...)] activation_tree! { ... }`";
pub(crate) const FIELD_ATTRIBUTE: &str =
    "the fields and components of a tree have no attributes: remove this; for another list write another tree";
pub(crate) const TREE_FIELDS: &str = "the fields of a tree stand in braces: `struct Name { root: ..., ... }`";
pub(crate) const AFTER_TREE: &str = "nothing follows the braces of a tree: write this outside the macro";
pub(crate) const EMPTY_TREE: &str = "a tree lists at least its root: `components: [Name]`";
pub(crate) const COMPONENT_LIST: &str = "the components are a list in brackets: `components: [One, Other]`";
pub(crate) const COMPONENT_TYPE: &str = "a component is listed by its type, which the tree owns: write its name here";
pub(crate) const COMPONENT_VALUE: &str =
    "a component is listed by its type: write its name here; in `components` a value can follow, `Name = Name::new()`";
pub(crate) const TREE_IN_ITSELF: &str = "the tree itself has this name: remove it here, or give the tree another name";
pub(crate) const COMPONENT_NAME: &str =
    "the name of a component is an identifier in small letters: write as in `left = Leg<0>`";
pub(crate) const NAME_SIGN: &str = "the name of a component is followed by `=`: write as in `left = Leg<0>`";
pub(crate) const VALUE_SIGN: &str = "an initial value follows `=`: write `Name = Name::new()`";
pub(crate) const SEMICOLON: &str = "the fields of a tree end with a comma: write `,` in place of each `;`";
pub(crate) const FIELD_NAME: &str =
    "a field of a tree is `root`, `cycle_hz`, `budget_ms`, `tunable`, `roles` or `components`";
pub(crate) const ROLE_LIST: &str =
    "the roles are a list in braces of traits and the components that provide them: `roles: { Role: Component }`";
pub(crate) const ONE_PROVIDER: &str = "a tree has one component for each role: write its name here";
pub(crate) const TOO_MANY_ROLES: &str = "a tree has at most 16 roles: put the methods of two roles into one";
pub(crate) const TUNABLE_VALUE: &str = "`tunable` takes no value: write `tunable` alone, followed by a comma";

pub(crate) fn derived(name: &str) -> String {
    match name {
        "Default" => "a tree implements `Default` already: remove this".to_owned(),
        _ => format!("a tree cannot derive `{name}`, it owns running components: remove this"),
    }
}

messages! {
    tree_of_a_component(name) = "the tree and its root are both called `{name}`: give the tree another name";
    tree_renamed(name) = "a tree has one name: write `struct {name}`";
    colon(key) = "a colon follows the name of a field: `{key}: ...`";
    missing(key, example) = "the tree has no `{key}`: add `{key}: {example}`";
    role_listed_twice(role) = "the role `{role}` has a component already: remove one, because a tree has one for each role";
    named_twice(name) = "another component of this tree is called `{name}`: give this one another name";
    named_component(name) =
        "`{name}` is the name of a component: its type follows, then perhaps a value, as in `{name} = Leg<0> = Leg::new()`";
    small_name(name, kind) = "the name of a component begins with a small letter: write `{name} = {kind}`";
    kind_listed_twice(kind, first, second) =
        "`{first}` and `{second}` are both `{kind}`, but a tree has one instance of a type: give the type a parameter, as in `Leg<0>` and `Leg<1>`";
    listed_twice(component) = "`{component}` is listed twice, but a tree has one instance of a component: remove one";
}
