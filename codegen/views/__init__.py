"""How the model is spelled in each target language. One small function per question."""
