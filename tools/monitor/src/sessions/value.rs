//! Values of the page and of the link.

use bica_link::{Description, Invalid, Param, Plain};
use bica_wire::message::{Change, MAX_ARGUMENTS, MAX_BATCH, Setting as WireSetting};

use crate::protocol::{Failed, HoldKind, Request, Setting};
use bica_wire::message::Hold;

impl Failed {
    /// An error with its remedy.
    #[must_use]
    pub fn new(text: impl Into<String>, help: impl Into<String>) -> Self {
        Self { text: text.into(), help: help.into(), entry: None, stale: false }
    }

    /// An error of a request about an older version of a text.
    pub(crate) fn stale(text: impl Into<String>, help: impl Into<String>) -> Self {
        Self { stale: true, ..Self::new(text, help) }
    }

    fn at(self, entry: usize) -> Self {
        Self { entry: Some(entry), ..self }
    }
}

impl From<bica_console::Failure> for Failed {
    fn from(failure: bica_console::Failure) -> Self {
        match failure {
            bica_console::Failure::Error { what, help } => Self::new(what, help),
            bica_console::Failure::BrokenPipe => Self::new("the output was closed", "start the program again"),
        }
    }
}

impl From<bica_link::Error> for Failed {
    fn from(error: bica_link::Error) -> Self {
        let entry = match &error {
            bica_link::Error::Refused { entry, .. } => Some(*entry),
            _ => None,
        };
        Self { entry, ..Self::new(error.to_string(), error.help()) }
    }
}

impl From<Invalid> for Failed {
    fn from(Invalid { what, help }: Invalid) -> Self {
        Self::new(what, help)
    }
}

/// Hold of the link.
pub(super) const fn wire_hold(hold: HoldKind) -> Hold {
    match hold {
        HoldKind::Tree => Hold::Tree,
        HoldKind::Active => Hold::Active,
        HoldKind::Latent => Hold::Latent,
    }
}

/// Hold of the page.
pub(super) const fn page_hold(hold: Hold) -> HoldKind {
    match hold {
        Hold::Tree => HoldKind::Tree,
        Hold::Active => HoldKind::Active,
        Hold::Latent => HoldKind::Latent,
    }
}

/// Error: an index that the description does not have.
pub(super) fn unknown(what: &str, index: usize) -> Failed {
    Failed::new(format!("there is no {what} {index}"), "the tree may have changed: reload the page")
}

/// Returns the setting of the link for a setting of the page.
fn wire_setting(description: &Description, setting: &Setting) -> Result<WireSetting, Failed> {
    let Setting { component, param, value } = setting;
    let owner = description.components.get(*component).ok_or_else(|| unknown("component", *component))?;
    let declared = owner.params.get(*param).ok_or_else(|| unknown("parameter", *param))?;
    let value = declared.value_of(value)?;
    Ok(WireSetting::new(bica::ComponentId::new(*component), *param as u16, value))
}

/// Returns the change of the link that a request of the page asks for; none for a request that is no change.
pub(super) fn change(description: &Description, request: &Request) -> Option<Result<Change, Failed>> {
    Some(match request {
        Request::Set { settings, .. } => params(description, settings),
        Request::Hold { component, hold, .. } => {
            known(description, *component).map(|component| Change::Hold { component, hold: wire_hold(*hold) })
        }
        Request::Rate { component, hz, .. } => {
            known(description, *component).and_then(|component| rate(description, component, *hz))
        }
        Request::Modulate { component, modulation, arguments, .. } => {
            modulate(description, *component, *modulation, arguments)
        }
        _ => return None,
    })
}

fn known(description: &Description, component: usize) -> Result<u16, Failed> {
    let is_known = component < description.components.len();
    is_known.then_some(component as u16).ok_or_else(|| unknown("component", component))
}

fn rate(description: &Description, component: u16, hz: Option<f32>) -> Result<Change, Failed> {
    let most = description.components[usize::from(component)].hz.unwrap_or(description.cycle_hz);
    if let Some(hz) = hz.filter(|hz| !(*hz > 0.0 && *hz <= most)) {
        let help = format!("choose more than 0 and at most {most} Hz, or the declared rate");
        return Err(Failed::new(format!("the rate {hz} Hz is outside its range"), help));
    }
    Ok(Change::Rate { component, hz: hz.unwrap_or(f32::NAN) })
}

fn params(description: &Description, settings: &[Setting]) -> Result<Change, Failed> {
    if settings.is_empty() || settings.len() > MAX_BATCH {
        let what = format!("{} parameters cannot be set in one batch", settings.len());
        return Err(Failed::new(what, format!("set 1 to {MAX_BATCH} at a time")));
    }
    let one = |(entry, setting)| wire_setting(description, setting).map_err(|failed: Failed| failed.at(entry));
    settings.iter().enumerate().map(one).collect::<Result<_, _>>().map(Change::Params)
}

fn modulate(
    description: &Description,
    component: usize,
    modulation: usize,
    arguments: &[Plain],
) -> Result<Change, Failed> {
    let owner = description.components.get(component).ok_or_else(|| unknown("component", component))?;
    let called = owner.modulations.get(modulation).ok_or_else(|| unknown("modulation", modulation))?;
    if called.arguments.len() != arguments.len() || arguments.len() > MAX_ARGUMENTS {
        let what = format!("`{}` takes {} arguments, found {}", called.name, called.arguments.len(), arguments.len());
        return Err(Failed::new(what, "give one value for each argument"));
    }
    let one = |(entry, (param, value)): (usize, (&Param, &Plain))| {
        param.value_of(value).map_err(|invalid| Failed::from(invalid).at(entry))
    };
    let arguments = called.arguments.iter().zip(arguments).enumerate().map(one).collect::<Result<_, _>>()?;
    Ok(Change::Modulate { component: component as u16, modulation: modulation as u16, arguments })
}
