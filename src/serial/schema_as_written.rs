//! The JSON Schema of types that are read through another type (feature `schema`).

/// Gives a type the schema of the type `$written`, through which serde reads it.
macro_rules! schema_as_written {
    ($name:literal, $type:ty, $written:ty $(, $dimension:ident)*) => {
        impl<$(const $dimension: usize),*> schemars::JsonSchema for $type {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                $name.into()
            }
            fn schema_id() -> std::borrow::Cow<'static, str> {
                <$written>::schema_id()
            }
            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                <$written>::json_schema(generator)
            }
        }
    };
}
pub(crate) use schema_as_written;
