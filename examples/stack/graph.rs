//! The calls of a program from one function on, and the most stack that they can take.

use std::collections::BTreeMap;

use crate::function::{self, Code};
use crate::image::{Function, Image};
use crate::names::short;
use crate::problem::Problem;

/// All functions that can be reached from one.
pub struct Graph<'i> {
    image: &'i Image,
    nodes: BTreeMap<u32, Node<'i>>,
    /// How the functions' frames are known.
    pub sources: Sources,
    pub problems: Vec<Problem>,
}

struct Node<'i> {
    function: &'i Function,
    code: Code,
    /// Bytes of stack of the function alone.
    frame: u32,
    /// Its worst case, once it is known: bytes of stack, and the call that leads to it.
    worst: Option<(u32, Option<u32>)>,
}

/// How many functions there are, by what their frames are known from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sources {
    /// The compiler's sizes, and the code agrees.
    pub compiler: usize,
    /// The code alone: functions that were compiled before.
    pub code: usize,
}

/// One function of a chain of calls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    pub name: String,
    /// Bytes of stack that it has in use when it calls the next, or at most.
    pub bytes: u32,
}

impl<'i> Graph<'i> {
    /// All that can be reached from the function of this name.
    pub fn from(image: &'i Image, name: &str) -> Result<(Self, u32), String> {
        let start = image.function_named(name).ok_or_else(|| format!("there is no function {name}"))?;
        let mut graph = Self { image, nodes: BTreeMap::new(), sources: Sources::default(), problems: Vec::new() };
        let mut waiting = vec![start];
        while let Some(function) = waiting.pop() {
            if graph.nodes.contains_key(&function.start) {
                continue;
            }
            let mut code = function::read(image, function);
            graph.problems.append(&mut code.problems);
            for call in &code.calls {
                match image.function_at(call.target) {
                    Some(callee) if callee.start == call.target => waiting.push(callee),
                    _ => graph.unclear(function, call.place, format!("calls {:#x}, where no function is", call.target)),
                }
            }
            let frame = graph.frame(function, &code);
            graph.nodes.insert(function.start, Node { function, code, frame, worst: None });
        }
        Ok((graph, start.start))
    }

    fn frame(&mut self, function: &Function, code: &Code) -> u32 {
        match self.image.stack_sizes.get(&function.start) {
            Some(&compiler) => {
                if compiler != code.frame {
                    let function = short(&function.name);
                    self.problems.push(Problem::Sizes { function, compiler, code: code.frame });
                }
                self.sources.compiler += 1;
                compiler
            }
            None => {
                self.sources.code += 1;
                code.frame
            }
        }
    }

    fn unclear(&mut self, function: &Function, address: u32, what: String) {
        self.problems.push(Problem::Unclear { function: short(&function.name), address, what });
    }

    /// The most bytes of stack that a function and all that it calls can have in use at once, and the chain of calls
    /// that has them.
    pub fn worst(&mut self, start: u32) -> (u32, Vec<Link>) {
        let bytes = self.visit(start, &mut Vec::new());
        let mut chain = Vec::new();
        let mut next = Some((start, bytes));
        while let Some((address, bytes)) = next {
            let Some(node) = self.nodes.get(&address) else { break };
            let callee = node.worst.and_then(|(_, call)| call);
            next = callee.and_then(|callee| Some((callee, self.nodes.get(&callee)?.worst?.0)));
            let rest = next.map_or(0, |(_, bytes)| bytes);
            chain.push(Link { name: short(&node.function.name), bytes: bytes - rest });
        }
        (bytes, chain)
    }

    fn visit(&mut self, address: u32, above: &mut Vec<u32>) -> u32 {
        let Some(node) = self.nodes.get(&address) else { return 0 };
        if let Some((bytes, _)) = node.worst {
            return bytes;
        }
        if let Some(first) = above.iter().position(|&function| function == address) {
            let circle = above.iter().skip(first).chain([&address]).filter_map(|function| self.nodes.get(function));
            self.problems.push(Problem::Recursion(circle.map(|node| short(&node.function.name)).collect()));
            return 0;
        }
        let (mut worst, calls) = ((node.frame, None), node.code.calls.clone());
        above.push(address);
        for call in calls {
            let bytes = call.depth + self.visit(call.target, above);
            // Of chains that need the same, the longest.
            if bytes >= worst.0 {
                worst = (bytes, Some(call.target));
            }
        }
        above.pop();
        if let Some(node) = self.nodes.get_mut(&address) {
            node.worst = Some(worst);
        }
        worst.0
    }

    /// The calls from one function to another, the shortest such chain.
    pub fn path(&self, start: u32, to: u32) -> Vec<String> {
        let mut paths = vec![vec![start]];
        let mut seen = vec![start];
        while let Some(path) = (!paths.is_empty()).then(|| paths.remove(0)) {
            let last = path.last().copied().unwrap_or(start);
            if last == to {
                let functions = path.iter().filter_map(|function| self.nodes.get(function));
                return functions.map(|node| short(&node.function.name)).collect();
            }
            for call in self.nodes.get(&last).into_iter().flat_map(|node| &node.code.calls) {
                if !seen.contains(&call.target) {
                    seen.push(call.target);
                    paths.push([path.as_slice(), &[call.target]].concat());
                }
            }
        }
        Vec::new()
    }

    /// Every place from which one function calls or jumps to another.
    pub fn calls(&self) -> impl Iterator<Item = (&Function, u32, u32)> {
        self.nodes.values().flat_map(|node| node.code.calls.iter().map(|call| (node.function, call.place, call.target)))
    }
}
