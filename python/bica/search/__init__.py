"""Series of games and searches of parameters, on one computer or many."""
