#version 330 core

flat in vec4 lineColour;
out vec4 colour;

void main() { colour = lineColour; }
