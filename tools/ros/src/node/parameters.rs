//! The parameter services of the node.

use bica_recording::ros::{ListResult, Names, Parameter};
use bica_wire::model::Invalid;
use ros2_client::dds::Server;

use super::network::Network;
use super::pending::Reply;
use super::robot::Robot;
use super::values::{describe, get, list, names, setting};
use crate::message::{
    Descriptors, List, Listed, Names as Asked, Parameters as Set, Results, SingleResult, Types, Values,
};

/// The services.
pub(super) struct Parameters {
    list: Server<List, Listed>,
    get: Server<Asked, Values>,
    types: Server<Asked, Types>,
    describe: Server<Asked, Descriptors>,
    set: Server<Set, Results>,
    set_atomically: Server<Set, SingleResult>,
}

impl Parameters {
    pub(super) fn serve(network: &mut Network, names: &Names) -> Result<Self, Invalid> {
        let name = |service: &str| names.private(&[service]);
        let kind = |name| ("rcl_interfaces", name);
        Ok(Self {
            list: network.serve(&name("list_parameters"), kind("ListParameters"))?,
            get: network.serve(&name("get_parameters"), kind("GetParameters"))?,
            types: network.serve(&name("get_parameter_types"), kind("GetParameterTypes"))?,
            describe: network.serve(&name("describe_parameters"), kind("DescribeParameters"))?,
            set: network.serve(&name("set_parameters"), kind("SetParameters"))?,
            set_atomically: network.serve(&name("set_parameters_atomically"), kind("SetParametersAtomically"))?,
        })
    }

    /// Answers queries, and passes new values on to the robot.
    pub(super) fn handle(&self, robot: &mut Robot) -> Result<(), bica_link::Error> {
        // A request that cannot be read has no answer.
        while let Ok(Some((id, List { prefixes, depth }))) = self.list.receive_request() {
            let (names, prefixes) = list(names(robot.link.description()), &prefixes, depth);
            let _ = self.list.send_response(id, Listed { result: ListResult { names, prefixes } });
        }
        while let Ok(Some((id, Asked { names }))) = self.get.receive_request() {
            let values = names.iter().map(|name| get(robot.link.description(), robot.simulated, name)).collect();
            let _ = self.get.send_response(id, Values { values });
        }
        while let Ok(Some((id, Asked { names }))) = self.types.receive_request() {
            let kind = |name: &String| get(robot.link.description(), robot.simulated, name).r#type;
            let _ = self.types.send_response(id, Types { types: names.iter().map(kind).collect() });
        }
        while let Ok(Some((id, Asked { names }))) = self.describe.receive_request() {
            let descriptors = names.iter().map(|name| describe(robot.link.description(), name)).collect();
            let _ = self.describe.send_response(id, Descriptors { descriptors });
        }
        while let Ok(Some((id, Set { parameters }))) = self.set.receive_request() {
            let batch = robot.pending.begin(Reply::Each(id), parameters.len());
            for (entry, parameter) in parameters.iter().enumerate() {
                robot.set(id.writer_gid, std::slice::from_ref(parameter), (batch, entry))?;
            }
        }
        while let Ok(Some((id, Set { parameters }))) = self.set_atomically.receive_request() {
            let batch = robot.pending.begin(Reply::All(id), 1);
            robot.set(id.writer_gid, &parameters, (batch, 0))?;
        }
        for (reply, results) in robot.pending.take_complete(|reply| matches!(reply, Reply::Each(_) | Reply::All(_))) {
            let _ = match reply {
                Reply::All(id) => {
                    let result = results.into_iter().next().unwrap_or_default();
                    self.set_atomically.send_response(id, SingleResult { result })
                }
                Reply::Each(id) => self.set.send_response(id, Results { results }),
                Reply::Call(..) => Ok(()),
            };
        }
        Ok(())
    }
}

impl Robot {
    /// Requests to set parameters: all, or none if one is refused.
    fn set(
        &mut self,
        id: ros2_client::Gid,
        parameters: &[Parameter],
        place: (u64, usize),
    ) -> Result<(), bica_link::Error> {
        let settings = parameters.iter().map(setting).collect::<Result<Vec<_>, _>>();
        let request = settings.map(|settings| bica_wire::model::NamedRequest::Set { settings });
        self.request(id, request, place)
    }
}
