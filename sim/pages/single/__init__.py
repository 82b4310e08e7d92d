"""One HTML file that holds all that it needs: a scene, or a lesson."""
