//! A WebAssembly module that counts the instructions that it executes.
//!
//! An engine's own metering (fuel) charges blocks when they are entered, so that what a branch leaves out is counted too. Here
//! a count is added wherever control may go elsewhere or come from elsewhere, and is exact. Instructions that only mark the
//! borders of blocks are not counted, for an engine executes nothing for them.

use super::engine::COUNTER;
use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{
    CodeSection, ConstExpr, ExportKind, ExportSection, Function, GlobalSection, GlobalType, Instruction, ValType,
};
use wasmparser::{ExportSectionReader, FunctionBody, GlobalSectionReader, Operator};

/// The same module with a count.
pub fn counted(module: &[u8]) -> Result<Vec<u8>, String> {
    let mut counted = wasm_encoder::Module::new();
    let mut counter = Counter { global: None };
    let parsed = counter.parse_core_module(&mut counted, wasmparser::Parser::new(0), module);
    parsed.map_err(|error| error.to_string())?;
    Ok(counted.finish())
}

struct Counter {
    /// The number of the variable that counts.
    global: Option<u32>,
}

impl Reencode for Counter {
    type Error = &'static str;

    /// Adds the variable. The modules here import none, and have one at least, for the stack.
    fn parse_global_section(
        &mut self,
        globals: &mut GlobalSection,
        section: GlobalSectionReader<'_>,
    ) -> Result<(), Error<Self::Error>> {
        utils::parse_global_section(self, globals, section)?;
        self.global = Some(globals.len());
        let count = GlobalType { val_type: ValType::I64, mutable: true, shared: false };
        globals.global(count, &ConstExpr::i64_const(0));
        Ok(())
    }

    fn parse_export_section(
        &mut self,
        exports: &mut ExportSection,
        section: ExportSectionReader<'_>,
    ) -> Result<(), Error<Self::Error>> {
        utils::parse_export_section(self, exports, section)?;
        exports.export(COUNTER, ExportKind::Global, self.global()?);
        Ok(())
    }

    fn parse_function_body(
        &mut self,
        code: &mut CodeSection,
        body: FunctionBody<'_>,
    ) -> Result<(), Error<Self::Error>> {
        let mut function = self.new_function_with_parsed_locals(&body)?;
        let mut count = 0;
        for operator in body.get_operators_reader()? {
            let operator = operator?;
            count += i64::from(!is_border(&operator));
            if goes_elsewhere(&operator) && count > 0 {
                add(&mut function, self.global()?, count);
                count = 0;
            }
            function.instruction(&self.instruction(operator)?);
        }
        code.function(&function);
        Ok(())
    }
}

impl Counter {
    fn global(&self) -> Result<u32, Error<&'static str>> {
        self.global.ok_or(Error::UserError("the module has no variables"))
    }
}

/// Adds to the count. Nothing is left on the stack, nor taken from it.
fn add(function: &mut Function, global: u32, count: i64) {
    let steps = [
        Instruction::GlobalGet(global),
        Instruction::I64Const(count),
        Instruction::I64Add,
        Instruction::GlobalSet(global),
    ];
    for step in &steps {
        function.instruction(step);
    }
}

const fn is_border(operator: &Operator<'_>) -> bool {
    matches!(operator, Operator::Block { .. } | Operator::Loop { .. } | Operator::Else | Operator::End | Operator::Nop)
}

/// Whether what follows may not come next, or may come next from elsewhere: what came before has to be counted.
const fn goes_elsewhere(operator: &Operator<'_>) -> bool {
    matches!(
        operator,
        Operator::Loop { .. }
            | Operator::If { .. }
            | Operator::Else
            | Operator::End
            | Operator::Br { .. }
            | Operator::BrIf { .. }
            | Operator::BrTable { .. }
            | Operator::Return
            | Operator::Unreachable
            | Operator::Call { .. }
            | Operator::CallIndirect { .. }
    )
}

#[cfg(test)]
mod tests {
    use super::engine::COUNTER;
    use super::*;
    use wasm_encoder::{BlockType, FunctionSection, Module, TypeSection};

    /// A function with a loop that is gone through as often as its argument says, and a branch out of a block each time but the
    /// first: both leave instructions out.
    fn looping() -> Vec<u8> {
        let (mut types, mut functions) = (TypeSection::new(), FunctionSection::new());
        types.ty().function([ValType::I32], []);
        functions.function(0);
        let mut globals = GlobalSection::new();
        let variable = GlobalType { val_type: ValType::I32, mutable: true, shared: false };
        globals.global(variable, &ConstExpr::i32_const(0));
        let mut exports = ExportSection::new();
        exports.export("loop", ExportKind::Func, 0);
        let mut body = Function::new([]);
        let mut add = |steps: &[Instruction<'_>]| {
            for step in steps {
                body.instruction(step);
            }
        };
        add(&[Instruction::Loop(BlockType::Empty), Instruction::Block(BlockType::Empty)]);
        add(&[Instruction::GlobalGet(0), Instruction::BrIf(0)]); // 2, always
        add(&[Instruction::Nop, Instruction::I32Const(1), Instruction::GlobalSet(0), Instruction::End]); // 2, once
        add(&[Instruction::LocalGet(0), Instruction::I32Const(1), Instruction::I32Sub, Instruction::LocalTee(0)]);
        add(&[Instruction::BrIf(0), Instruction::End, Instruction::End]); // 5, always
        let mut code = CodeSection::new();
        code.function(&body);
        let mut module = Module::new();
        module.section(&types).section(&functions).section(&globals).section(&exports).section(&code);
        module.finish()
    }

    #[test]
    fn what_is_left_out_is_not_counted() {
        let engine = wasmi::Engine::default();
        let module = wasmi::Module::new(&engine, counted(&looping()).unwrap()).unwrap();
        for times in [1, 10] {
            let mut store = wasmi::Store::new(&engine, ());
            let instance = wasmi::Linker::new(&engine).instantiate_and_start(&mut store, &module).unwrap();
            instance.get_typed_func::<i32, ()>(&store, "loop").unwrap().call(&mut store, times).unwrap();
            let count = instance.get_global(&store, COUNTER).unwrap().get(&store).i64();
            assert_eq!(count, Some(i64::from(times) * 7 + 2));
        }
    }
}
