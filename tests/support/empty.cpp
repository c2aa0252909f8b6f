// Nothing: of its target only the precompiled header is wanted.
