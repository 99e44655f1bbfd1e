//! The parameters of the node: its settings, which other nodes may read.

use dobot_model::Model;
use ros2_client::ParameterValue;
use ros2_client::parameters::{ParameterType, raw};
use ros2_client::rcl_interfaces::{
    DescribeParametersRequest, DescribeParametersResponse, GetParameterTypesRequest,
    GetParameterTypesResponse, GetParametersRequest, GetParametersResponse, ListParametersRequest,
    ListParametersResponse, ListParametersResult, SetParametersAtomicallyResponse,
    SetParametersRequest, SetParametersResponse,
};

use crate::settings::Settings;

/// The parameters, in the order of their names.
#[derive(Clone, Debug)]
pub(crate) struct Parameters {
    all: Vec<Parameter>,
}

#[derive(Clone, Debug)]
struct Parameter {
    name: &'static str,
    value: ParameterValue,
    description: &'static str,
    /// How to change it.
    remedy: &'static str,
}

impl Parameters {
    pub(crate) fn new(settings: &Settings, model: &Model) -> Self {
        let parameter = |name, value, description, remedy| Parameter {
            name,
            value,
            description,
            remedy,
        };
        let tool = settings.tool.map_or("none", |tool| tool.kind().short());
        let length_mm = settings.tool.map_or(0.0, |tool| tool.length().0);
        let all = vec![
            parameter(
                "deviation_deg",
                ParameterValue::Double(settings.deviation_deg),
                "Maximum deviation of a thinned trajectory, in degrees, as far as the link can carry it",
                "start dobot-ros2 with --deviation",
            ),
            parameter(
                "robot_description",
                ParameterValue::String(model.to_urdf()),
                "The arm as URDF",
                "start dobot-ros2 with --tool and --length",
            ),
            parameter(
                "tool",
                ParameterValue::String(tool.to_owned()),
                "The mounted tool",
                "start dobot-ros2 with --tool",
            ),
            parameter(
                "tool_length_mm",
                ParameterValue::Double(length_mm),
                "Length of the tool below the wrist, in mm",
                "start dobot-ros2 with --length",
            ),
            parameter(
                "use_sim_time",
                ParameterValue::Boolean(false),
                "Stamps are in real time",
                "an arm has no other time",
            ),
        ];
        Self { all }
    }

    fn named(&self, name: &str) -> Option<&Parameter> {
        self.all.iter().find(|parameter| parameter.name == name)
    }

    /// Returns the names: all, or those of the request. No name has a prefix.
    pub(crate) fn list(&self, request: &ListParametersRequest) -> ListParametersResponse {
        let prefixes = &request.prefixes;
        let names = self.all.iter().map(|parameter| parameter.name);
        let wanted = names
            .filter(|name| prefixes.is_empty() || prefixes.iter().any(|prefix| prefix == name));
        ListParametersResponse {
            result: ListParametersResult {
                names: wanted.map(str::to_owned).collect(),
                prefixes: Vec::new(),
            },
        }
    }

    /// Returns the values; an unknown parameter has none.
    pub(crate) fn get(&self, request: &GetParametersRequest) -> GetParametersResponse {
        let value = |name: &String| match self.named(name) {
            Some(parameter) => parameter.value.clone().into(),
            None => ParameterValue::NotSet.into(),
        };
        GetParametersResponse {
            values: request.names.iter().map(value).collect(),
        }
    }

    pub(crate) fn types(&self, request: &GetParameterTypesRequest) -> GetParameterTypesResponse {
        GetParameterTypesResponse {
            values: request.names.iter().map(|name| self.kind(name)).collect(),
        }
    }

    fn kind(&self, name: &str) -> u8 {
        let value = self.named(name).map(|parameter| &parameter.value);
        value.map_or(ParameterType::NotSet, ParameterValue::to_parameter_type) as u8
    }

    pub(crate) fn describe(
        &self,
        request: &DescribeParametersRequest,
    ) -> DescribeParametersResponse {
        let described = |name: &String| {
            let known = self.named(name);
            raw::ParameterDescriptor {
                name: name.clone(),
                r#type: self.kind(name),
                description: known.map_or("", |known| known.description).to_owned(),
                additional_constraints: known.map_or("", |known| known.remedy).to_owned(),
                read_only: true,
                dynamic_typing: false,
                floating_point_range: Vec::new(),
                integer_range: Vec::new(),
            }
        };
        DescribeParametersResponse {
            values: request.names.iter().map(described).collect(),
        }
    }

    /// Refuses every change, with what to do instead.
    pub(crate) fn set(&self, request: &SetParametersRequest) -> SetParametersResponse {
        let names = request.parameter.iter().map(|parameter| &parameter.name);
        SetParametersResponse {
            results: names.map(|name| self.refused(name)).collect(),
        }
    }

    /// Refuses every change, with what to do instead.
    pub(crate) fn set_atomically(
        &self,
        request: &SetParametersRequest,
    ) -> SetParametersAtomicallyResponse {
        let name = request.parameter.first().map_or("", |first| &first.name);
        SetParametersAtomicallyResponse {
            result: self.refused(name),
        }
    }

    fn refused(&self, name: &str) -> raw::SetParametersResult {
        let reason = self.named(name).map_or_else(
            || {
                let names: Vec<&str> = self.all.iter().map(|known| known.name).collect();
                let names = names.join(", ");
                format!("there is no parameter {name:?}; there are {names}")
            },
            |known| format!("{name} is read-only; {}", known.remedy),
        );
        raw::SetParametersResult {
            successful: false,
            reason,
        }
    }
}
