"""Messages of the API, generated from proto/ when the package is built."""
