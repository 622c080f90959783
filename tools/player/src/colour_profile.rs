//! Colour profile as values for the parameters of `Colours`.

use bica_app::Failure;
use bica_app::Layer;
use bica_evaluation::profile::load;
use bica_tuning::Layers;
use bica_vision::colour::{Colour, Filter};
use clap::Args;

/// Layer of the limits of colour classes.
#[derive(Clone, Debug, Args)]
pub struct ColourProfile {
    /// Colour profile whose limits are the parameters of `Colours`, over the tune file of the world and below that of the robot:
    /// built-in, nao2009 or darwin2013, or a TOML file
    #[arg(long, value_name = "PROFILE")]
    profile: Option<String>,
}

impl Layer for ColourProfile {
    fn assign(&self, layers: &mut Layers) -> Result<(), Failure> {
        let Some(name) = &self.profile else { return Ok(()) };
        let source = format!("profile {name}");
        for (colour, filter) in load(name)?.in_order() {
            let class = format!("{colour:?}").to_lowercase();
            let limits = if colour == Colour::White { white(filter) } else { coloured(filter) };
            let limits = limits.map_err(|(what, help)| Failure::new(format!("`{name}`: `{class}` {what}"), help))?;
            for (limit, value) in limits {
                let assignment = format!("Colours.{class}_{limit}={value}");
                layers.assign(&assignment, &source).map_err(|invalid| invalid.within(&source))?;
            }
        }
        Ok(())
    }
}

type Limits = Result<Vec<(&'static str, u16)>, (&'static str, &'static str)>;

fn coloured(filter: &Filter) -> Limits {
    let (from, to) = filter.hue_range().ok_or(("has no range of hues", "write it as `hue = [from, to]`"))?;
    let (least, most) = filter.saturation_range();
    let (dark, bright) = filter.luma_bounds();
    if most == u16::MAX {
        return Err(("has no range of saturations", "write it as `saturation = [min, max]`, at most 1000"));
    }
    Ok(vec![
        ("hue_from", from.unsigned_abs()),
        ("hue_to", to.unsigned_abs()),
        ("saturation_min", least),
        ("saturation_max", most),
        ("luma_min", dark.into()),
        ("luma_max", bright.into()),
        ("chroma_min", filter.least_chroma().into()),
    ])
}

fn white(filter: &Filter) -> Limits {
    let ((least, most), (dark, bright)) = (filter.saturation_range(), filter.luma_bounds());
    if filter.hue_range().is_some() || filter.least_chroma() > 0 || least > 0 || most == u16::MAX {
        let help = "give it `saturation = [0, max]` and `luma = [min, max]` only";
        return Err(("has other limits than a maximum saturation and a range of luma", help));
    }
    Ok(vec![("saturation_max", most), ("luma_min", dark.into()), ("luma_max", bright.into())])
}
