// The program: picks the command.
int main() { return 2; }
