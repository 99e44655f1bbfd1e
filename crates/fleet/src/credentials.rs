//! By what stations prove that they belong to a fleet: certificates of an authority of its own.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use dobot_api::{is_fleet_name, write_private};
use rcgen::{BasicConstraints, CertificateParams, DnType, IsCa, Issuer, KeyPair};

/// By what a station proves that it belongs to a fleet: a folder with `authority.pem`, `certificate.pem` and `key.pem`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Credentials {
    folder: PathBuf,
}

const AUTHORITY: &str = "authority.pem";
const AUTHORITY_KEY: &str = "authority-key.pem";
const CERTIFICATE: &str = "certificate.pem";
const KEY: &str = "key.pem";

/// Why there are no credentials.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CredentialsError {
    /// A file is missing.
    #[error(
        "{file} is missing; `dobot fleet certificates FOLDER NAME...` makes a folder with authority.pem, certificate.pem and key.pem for each NAME"
    )]
    Missing {
        /// The file.
        file: String,
    },
    /// A name that no station can have.
    #[error(
        "{0:?} is no name of a station; allowed are 1 to 40 small letters of English, digits and hyphens, the first one a letter"
    )]
    Name(String),
    /// A name or an address by which nobody is found.
    #[error(
        "{0:?} is no host; allowed are names and addresses as others connect to, as in router=router.school,192.168.7.1"
    )]
    Host(String),
    /// A certificate would be replaced.
    #[error("{0} is there already; nothing was made")]
    Exists(String),
    /// A file cannot be read or written.
    #[error("{file} cannot be read or written")]
    File {
        /// The file.
        file: String,
        /// Why.
        #[source]
        source: std::io::Error,
    },
    /// No certificate comes of it.
    #[error("the certificate cannot be made: {0}")]
    Certificate(#[from] rcgen::Error),
}

impl Credentials {
    /// The credentials in a folder.
    ///
    /// # Errors
    ///
    /// [`CredentialsError::Missing`].
    pub fn read(folder: &Path) -> Result<Self, CredentialsError> {
        let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
        let credentials = Self { folder };
        match credentials.files().into_iter().find(|it| !it.is_file()) {
            None => Ok(credentials),
            Some(missing) => Err(CredentialsError::Missing {
                file: missing.display().to_string(),
            }),
        }
    }

    /// Makes a folder for each holder. The authority is made where there is none yet: whoever has its key can let
    /// others in.
    ///
    /// # Errors
    ///
    /// [`CredentialsError`]; no certificate is replaced.
    pub fn make(folder: &Path, holders: &[Holder]) -> Result<Vec<Self>, CredentialsError> {
        let mut places = holders.iter().map(|it| folder.join(&it.name));
        if let Some(there) = places.find(|it| it.exists()) {
            return Err(CredentialsError::Exists(there.display().to_string()));
        }
        let authority = Authority::of(folder)?;
        let one = |holder: &Holder| authority.certify(&folder.join(&holder.name), holder);
        holders.iter().map(one).collect()
    }

    /// The authority's certificate, the own one, and its key.
    pub(crate) fn files(&self) -> [PathBuf; 3] {
        [AUTHORITY, CERTIFICATE, KEY].map(|it| self.folder.join(it))
    }
}

/// Who gets a certificate, and where others find him.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Holder {
    name: String,
    hosts: Vec<String>,
}

/// As in `desk-3`, or `router=router.school,192.168.7.1` for one whom others connect to by those names and addresses.
impl FromStr for Holder {
    type Err = CredentialsError;

    fn from_str(text: &str) -> Result<Self, CredentialsError> {
        // Nobody connects to a desk that joins by a router: its certificate says its name.
        let (name, hosts) = text.split_once('=').unwrap_or((text, text));
        if !is_fleet_name(name) {
            return Err(CredentialsError::Name(name.chars().take(60).collect()));
        }
        let is_plain = |it: char| it.is_ascii_alphanumeric() || ".-:".contains(it);
        let hosts: Vec<String> = hosts.split(',').map(Into::into).collect();
        let wrong = |it: &&String| it.is_empty() || !it.chars().all(is_plain);
        if let Some(wrong) = hosts.iter().find(wrong) {
            return Err(CredentialsError::Host(wrong.chars().take(60).collect()));
        }
        Ok(Self {
            name: name.into(),
            hosts,
        })
    }
}

impl Holder {
    /// What the holder is called.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

/// Who says who belongs to the fleet.
struct Authority {
    certificate: String,
    issuer: Issuer<'static, KeyPair>,
}

impl Authority {
    /// The one in the folder, which is made where there is none.
    fn of(folder: &Path) -> Result<Self, CredentialsError> {
        let [certificate, key] = [AUTHORITY, AUTHORITY_KEY].map(|it| folder.join(it));
        if !key.exists() {
            let pair = KeyPair::generate()?;
            write(&certificate, &authority().self_signed(&pair)?.pem())?;
            write(&key, &pair.serialize_pem())?;
        }
        Ok(Self {
            certificate: read(&certificate)?,
            issuer: Issuer::new(authority(), KeyPair::from_pem(&read(&key)?)?),
        })
    }

    fn certify(&self, folder: &Path, holder: &Holder) -> Result<Credentials, CredentialsError> {
        let pair = KeyPair::generate()?;
        let mut params = CertificateParams::new(holder.hosts.clone())?;
        let subject = &mut params.distinguished_name;
        subject.push(DnType::CommonName, holder.name());
        let certificate = params.signed_by(&pair, &self.issuer)?;
        write(&folder.join(AUTHORITY), &self.certificate)?;
        write(&folder.join(CERTIFICATE), &certificate.pem())?;
        write(&folder.join(KEY), &pair.serialize_pem())?;
        Credentials::read(folder)
    }
}

/// What the authority's certificate says.
fn authority() -> CertificateParams {
    let mut params = CertificateParams::default();
    let name = &mut params.distinguished_name;
    name.push(DnType::CommonName, "dobot fleet");
    params.is_ca = IsCa::Ca(BasicConstraints::Unconstrained);
    params
}

fn read(file: &Path) -> Result<String, CredentialsError> {
    std::fs::read_to_string(file).map_err(|source| of_file(file, source))
}

fn write(file: &Path, text: &str) -> Result<(), CredentialsError> {
    write_private(file, text).map_err(|source| of_file(file, source))
}

fn of_file(file: &Path, source: std::io::Error) -> CredentialsError {
    CredentialsError::File {
        file: file.display().to_string(),
        source,
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn names(names: &[&str]) -> Vec<Holder> {
        names.iter().map(|it| it.parse().unwrap()).collect()
    }

    #[test]
    fn a_desk_that_comes_later_gets_a_certificate_of_the_same_authority() {
        let folder = tempfile::tempdir().unwrap();
        let first = Credentials::make(folder.path(), &names(&["desk-1", "router"])).unwrap();
        let later = Credentials::make(folder.path(), &names(&["desk-2"])).unwrap();
        let authority = |it: &Credentials| std::fs::read_to_string(&it.files()[0]).unwrap();
        assert_eq!(authority(&first[0]), authority(&later[0]));
        assert_eq!(
            Credentials::read(&folder.path().join("desk-2")).unwrap(),
            later[0]
        );
    }

    #[test]
    fn no_certificate_is_replaced_and_no_folder_is_left_by_what_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        Credentials::make(folder.path(), &names(&["desk-1"])).unwrap();
        let error = Credentials::make(folder.path(), &names(&["desk-2", "desk-1"])).unwrap_err();
        assert!(
            error
                .to_string()
                .ends_with("desk-1 is there already; nothing was made")
        );
        assert!(!folder.path().join("desk-2").exists());
        let error = "../desk".parse::<Holder>().unwrap_err();
        assert!(matches!(error, CredentialsError::Name(_)), "{error}");
        for bad in ["router=", "router=a,", "router=a b", "router=*"] {
            let error = bad.parse::<Holder>().unwrap_err();
            assert!(matches!(error, CredentialsError::Host(_)), "{bad}: {error}");
        }
        let error = Credentials::read(&folder.path().join("desk-9")).unwrap_err();
        assert!(
            error.to_string().contains("authority.pem is missing"),
            "{error}"
        );
    }
}
