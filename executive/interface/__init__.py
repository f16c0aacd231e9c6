"""The interface as data and as documents: JSON Schemas, AsyncAPI, generated pages."""
