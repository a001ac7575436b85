#version 410 core
// Writes depth only.
void main() {}
