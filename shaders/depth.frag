#version 450 core
// Writes depth only.
void main() {}
