"""The grader of the exercises: see ../AUTHORING.md. Standard library only, Python 3.8 or newer."""
